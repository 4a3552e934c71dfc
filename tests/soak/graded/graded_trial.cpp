#include "graded_trial.hpp"

#include <algorithm>
#include <memory>
#include <random>

#include "certet/checksum.hpp"
#include "certet/write_mesh.hpp"
#include "domains.hpp"
#include "holes.hpp"
#include "materials.hpp"
#include "nowhere.hpp"
#include "property/graded_mesh.hpp"
#include "seed.hpp"

namespace graded {
namespace {

using certet::Lattice;
using certet::Stuffing;
using Random = std::mt19937_64;

Lattice random_lattice(Random& random) {
  const auto place = [&] { return 2 * between(random, -60, 60); };
  const auto extent = [&] { return between(random, 5, 22); };
  return {{place(), place(), place()}, {extent(), extent(), extent()}};
}

/// Balls of materials 0 to 3 in the second, one after the other.
std::unique_ptr<certet::Domain> of_materials(Random& random, const Lattice& lattice) {
  std::vector<std::pair<domains::Level, certet::Material>> balls;
  for (int n = between(random, 1, 5); n > 0; --n) {
    const auto at = [&](std::int32_t from, std::int32_t cells) {
      return from + std::uniform_real_distribution(0.0, 2.0 * cells)(random);
    };
    const double x = at(lattice.origin.x, lattice.cells[0]);
    const double y = at(lattice.origin.y, lattice.cells[1]);
    const double z = at(lattice.origin.z, lattice.cells[2]);
    const double radius = std::uniform_real_distribution(2.0, 16.0)(random);
    balls.push_back({domains::sphere(x, y, z, radius), between(random, 0, 3)});
  }
  return std::make_unique<materials::Positional>(
      std::vector<std::int32_t>{11, 12, 13}, [balls](Coord3 p) -> certet::Material {
        constexpr double unit = certet::steps;
        certet::Material material = 2;
        for (const auto& [ball, inside] : balls)
          if (ball(p.x / unit, p.y / unit, p.z / unit) < 0) material = inside;
        return material;
      });
}

/// Blocks of large and small: the most levels at a point.
struct AskedLevels {
  std::uint64_t seed;
  std::int32_t side;

  [[nodiscard]] std::int32_t at(Coord3 point) const {
    const auto block = [this](std::int32_t c) { return (c >= 0 ? c : c - side + 1) / side; };
    return static_cast<std::int32_t>(mixed(seed, block(point.x), block(point.y), block(point.z)) %
                                     5) - 1;
  }
};

/// Everything that a trial is, by chance.
struct Trial {
  Lattice lattice;
  std::unique_ptr<certet::Domain> domain;
  certet::Method method{};
  certet::Grading grading;
  AskedLevels asked{};
  bool several = false;
};

Trial make_trial(Random& random) {
  Trial trial;
  trial.lattice = random_lattice(random);
  trial.several = between(random, 0, 2) == 0;
  constexpr std::array methods{certet::Method::embedded, certet::Method::midpoint,
                               certet::Method::key, certet::Method::angles,
                               certet::Method::embedding};
  trial.method = methods[static_cast<std::size_t>(between(random, 0, trial.several ? 1 : 4))];
  if (trial.several)
    trial.domain = of_materials(random, trial.lattice);
  else
    trial.domain = std::make_unique<domains::Positional>(
        domains::with_holes(random, trial.lattice, between(random, 0, 5), 4));
  trial.grading.levels = between(random, 1, certet::most_grading_levels);
  if (trial.several && between(random, 0, 1) == 0)
    for (int n = 0; n < 3; ++n) trial.grading.of_materials.push_back(between(random, 0, 3));
  trial.asked = {random(), 2 * between(random, 1, 12)};
  if (between(random, 0, 1) == 0)
    trial.grading.at_points = [asked = trial.asked](std::span<const Coord3> points,
                                                    std::span<std::int32_t> levels) {
      std::ranges::transform(points, levels.begin(), [&](Coord3 p) { return asked.at(p); });
    };
  return trial;
}

void spoil(PlacedMesh& mesh, Plant plant) {
  auto& tet = *std::ranges::max_element(
      mesh.tets, {}, [](const PlacedTet& t) { return exact::six_volume(t.corners); });
  if (plant == Plant::flipped_tet) std::swap(tet.corners[0], tet.corners[1]);
  if (plant == Plant::other_label) ++tet.label;
  if (plant == Plant::missing_tet) tet = mesh.tets.back(), mesh.tets.pop_back();
}

/// Keeps a checksum alone: of lattice positions, which the frame leaves as they are.
std::uint64_t streamed(const Stuffing& stuffing, std::uint64_t bytes, certet::Context& context) {
  Nowhere nowhere;
  return certet::write_mesh(stuffing, {}, certet::cut_slabs(stuffing, bytes), nowhere, context)
      .checksum;
}

/// The levels that are allowed where a tetrahedron's centre is: of the cell of level 0 there.
std::int32_t allowed(const Trial& trial, const PlacedTet& tet) {
  Coord3 centre{0, 0, 0};
  for (const Coord3 p : tet.corners)
    centre = centre + Coord3{p.x / 4, p.y / 4, p.z / 4};
  const auto odd = [](std::int32_t c) { return 2 * (c >> (certet::step_bits + 1)) + 1; };
  std::int32_t most = trial.grading.levels;
  if (trial.grading.at_points)
    most = std::min(most, std::max(trial.asked.at({odd(centre.x), odd(centre.y), odd(centre.z)}), 0));
  if (!trial.grading.of_materials.empty())
    most = std::min(most, trial.grading.of_materials[static_cast<std::size_t>(tet.label - 11)]);
  return most;
}

/// Those of a pyramid's are as long as the diagonals of its cells; at the surface edges move.
bool is_larger(const Trial& trial, const PlacedTet& tet) {
  const double longest = longest_edge(tet);
  return longest > 1.9 && longest > 1.4143 * (1 << allowed(trial, tet));
}

}  // namespace

Verdict judge(std::uint64_t seed, std::uint64_t number, Plant plant) {
  Random random(trial_seed(seed, number));
  const Trial trial = make_trial(random);
  certet::Context context;
  context.threads = between(random, 1, 2);
  Stuffing stuffing(*trial.domain, trial.lattice, trial.method, context);
  Verdict verdict;
  verdict.several = trial.several;
  verdict.asked = trial.grading.at_points || !trial.grading.of_materials.empty();
  const PlacedMesh uniform = placed(stuffing);
  certet::Grading told = trial.grading;
  if (plant == Plant::forgotten_size) told = {.levels = told.levels, .of_materials = {}, .at_points = {}};
  stuffing.grade(told, context);
  verdict.tets = stuffing.tet_count();
  verdict.uniform_tets = stuffing.uniform_tet_count();
  verdict.smaller = verdict.tets < verdict.uniform_tets;
  if (verdict.tets == 0) return verdict;
  PlacedMesh mesh = placed(stuffing);
  spoil(mesh, plant);
  const auto expect = [&](bool holds, std::string sentence) {
    if (!holds) verdict.faults.push_back(std::move(sentence));
  };
  if (std::string found = fault(mesh, uniform, range_of(stuffing.method())); !found.empty())
    verdict.faults.push_back(std::move(found));
  expect(volumes(mesh) == volumes(uniform), "the volume of a material is another one");
  expect(uniform.tets.size() == verdict.uniform_tets, "the uniform mesh is counted wrong");
  expect(std::ranges::none_of(mesh.tets, [&](const auto& tet) { return is_larger(trial, tet); }),
         "a tetrahedron is larger than was asked for");
  certet::Mesh whole = certet::emit(stuffing, {}, context);
  if (plant == Plant::streamed_step) whole.points[0].y += 1;
  expect(streamed(stuffing, random() % 3 * 100'000, context) == certet::checksum(whole),
         "streamed, the mesh is another one");
  stuffing.grade({}, context);
  expect(placed(stuffing).tets == uniform.tets, "grading cannot be taken back");
  return verdict;
}

}  // namespace graded
