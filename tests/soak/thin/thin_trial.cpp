#include <array>

#include "thin_trial.hpp"

#include <algorithm>
#include <random>
#include <set>
#include <utility>

#include "certet/stuffing.hpp"
#include "domains.hpp"
#include "overlap.hpp"
#include "property/topology.hpp"
#include "thin_image.hpp"
#include "whole_mesh.hpp"

namespace thin {
namespace {

using certet::Coord3;
using certet::Lattice;
using certet::Sign;
using Vertices = std::vector<Coord3>;

Vertices vertices_of(const Lattice& lattice) {
  Vertices vertices;
  const auto [nx, ny, nz] = lattice.cells;
  for (std::int32_t odd = 0; odd < 2; ++odd)
    for (std::int32_t k = 0; k < nz; ++k)
      for (std::int32_t j = 0; j < ny; ++j)
        for (std::int32_t i = 0; i < nx; ++i)
          vertices.push_back(lattice.origin + Coord3{2 * i + odd, 2 * j + odd, 2 * k + odd});
  return vertices;
}

/// The lattice points where a domain is +, but for the outermost ones.
std::set<Coord3> inside(const certet::Domain& domain, const Lattice& lattice) {
  std::set<Coord3> found;
  for (const Coord3 v : vertices_of(lattice)) {
    const Coord3 d = v - lattice.origin;
    const auto outermost = [](std::int32_t c, std::int32_t cells) {
      return c < 2 || c >= 2 * cells - 2;
    };
    if (outermost(d.x, lattice.cells[0]) || outermost(d.y, lattice.cells[1]) ||
        outermost(d.z, lattice.cells[2]))
      continue;
    Sign sign{};
    domain.row(v, {&sign, 1});
    if (sign == Sign::plus) found.insert(v);
  }
  return found;
}

/// In how many groups the even neighbours of an odd point are that are inside.
int groups_around(Coord3 odd, const std::set<Coord3>& inside) {
  Vertices left;
  for (const std::int32_t x : {-1, 1})
    for (const std::int32_t y : {-1, 1})
      for (const std::int32_t z : {-1, 1})
        if (inside.contains(odd + Coord3{x, y, z})) left.push_back(odd + Coord3{x, y, z});
  int count = 0;
  while (!left.empty()) {
    ++count;
    Vertices group{left.back()};
    left.pop_back();
    for (std::size_t n = 0; n < group.size(); ++n)
      std::erase_if(left, [&](Coord3 v) {
        const Coord3 d = v - group[n];
        const bool beside = std::abs(d.x) + std::abs(d.y) + std::abs(d.z) == 2;
        if (beside) group.push_back(v);
        return beside;
      });
  }
  return count;
}

/// Without the odd points that join so many groups.
std::set<Coord3> parted(const std::set<Coord3>& all, int groups) {
  std::set<Coord3> kept;
  for (const Coord3 v : all)
    if ((v.x & 1) == 0 || groups_around(v, all) < groups) kept.insert(v);
  return kept;
}

/// A domain with other samples, which asks for no rule.
class Resampled final : public certet::Domain {
 public:
  Resampled(const certet::Domain& domain, std::set<Coord3> inside)
      : domain_(domain), inside_(std::move(inside)) {}
  void row(Coord3 first, std::span<Sign> out) const override {
    for (Sign& sign : out) {
      sign = inside_.contains(first) ? Sign::plus : Sign::minus;
      first.x += 2;
    }
  }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    domain_.at(positions, out);
  }

 private:
  const certet::Domain& domain_;
  std::set<Coord3> inside_;
};

/// What is meshed, and what is known of it.
struct Subject {
  std::unique_ptr<certet::Domain> domain;
  Lattice lattice;
  std::optional<std::int64_t> pieces;  ///< of the voxels, by faces
};

Subject image_subject(std::uint64_t seed, std::uint64_t number) {
  const ThinImage image = make_image(seed, number);
  auto domain = certet::label_domain(
      image.image(), {},
      {.size = image.lattice_size, .margin = 1, .walls_halfway = false});
  const Lattice lattice = domain->lattice();
  return {std::move(domain), lattice, image.pieces()};
}

/// Noise at every position, or at lattice points with cuts anywhere, near the ends, or
/// next to the thresholds; some with samples on the surface.
Subject field_subject(std::uint64_t seed, std::uint64_t number) {
  const std::uint64_t own = trial_seed(seed, number);
  std::mt19937_64 random(own);
  const unsigned zeros = between(random, 0, 1) == 0 ? 0 : static_cast<unsigned>(between(random, 1, 80));
  static const std::array<std::vector<std::int32_t>, 4> cuts{{
      {0, 3000, 9000, 17000, 30000, 42000, 60000, 65535},
      {0, 1, 18687, 18688, 26111, 26112, 39424, 46848, 65535},
      {10, 20000, 32768, 50000},
      {16384, 16385, 17000, 18687},
  }};
  const std::size_t kind = number % 5;
  Subject subject;
  subject.domain = std::make_unique<domains::Positional>(
      kind == 4 ? domains::noise(own, zeros) : domains::random_cuts(own, zeros, cuts[kind]));
  for (auto& cells : subject.lattice.cells) cells = between(random, 5, 9);
  subject.lattice.origin = {2 * between(random, -9, 0), 2 * between(random, -9, 0), 2 * between(random, -9, 0)};
  return subject;
}

settling::Tets mesh_of(const certet::Domain& domain, const Lattice& lattice,
                       certet::Method method, Plant plant) {
  if (plant == Plant::published_rule) method = certet::Method::angles;
  settling::Tets tets = settling::tets_of(whole_mesh(domain, lattice, method));
  if (plant == Plant::moved_point && !tets.points.empty())
    tets.points[tets.points.size() / 2] = tets.points[tets.points.size() / 2] + Coord3{60000, 0, 0};
  return tets;
}

std::string compared(std::string_view what, std::int64_t found, std::int64_t expected) {
  return std::string(what) + ": " + std::to_string(found) + ", not " + std::to_string(expected);
}

/// The first count that is another one.
std::string shape_fault(const settling::Tets& mesh, const topology::Shape& samples,
                        std::optional<std::int64_t> voxel_pieces) {
  if (voxel_pieces && samples.pieces != *voxel_pieces)
    return compared("pieces of the samples", samples.pieces, *voxel_pieces);
  const topology::Shape made = topology::of_mesh(mesh);
  if (made.pieces != samples.pieces) return compared("pieces", made.pieces, samples.pieces);
  if (made.tunnels != samples.tunnels) return compared("tunnels", made.tunnels, samples.tunnels);
  if (made.cavities != samples.cavities) return compared("cavities", made.cavities, samples.cavities);
  const std::int64_t by_faces = topology::pieces_by_faces(mesh);
  if (by_faces != samples.pieces) return compared("pieces by faces", by_faces, samples.pieces);
  return "";
}

/// Measures the tetrahedra; the first that is wrong with one.
std::string tet_fault(const std::vector<exact::Tet>& tets, const exact::AngleRange& range,
                      Verdict& verdict) {
  for (const exact::Tet& tet : tets) {
    if (exact::six_volume(tet) <= 0) return "a tetrahedron is not positive";
    for (const exact::Dihedral& angle : exact::dihedrals(tet)) {
      verdict.min_dihedral = std::min(verdict.min_dihedral, double(angle.degrees()));
      verdict.max_dihedral = std::max(verdict.max_dihedral, double(angle.degrees()));
      if (!range.contains(angle)) return "an angle is out of range";
    }
  }
  const Overlaps overlap = overlaps(tets);
  verdict.pairs = overlap.looked_at;
  return overlap.found == 0 ? "" : std::to_string(overlap.found) + " pairs of tetrahedra overlap";
}

}  // namespace

Verdict judge(Source source, std::uint64_t seed, std::uint64_t number, certet::Method method,
              Plant plant) {
  const Subject subject =
      source == Source::image ? image_subject(seed, number) : field_subject(seed, number);
  const std::set<Coord3> all = inside(*subject.domain, subject.lattice);
  std::set<Coord3> samples = subject.pieces ? parted(all, 2) : all;
  settling::Tets mesh;
  if (subject.pieces && (plant == Plant::forgotten_rule || plant == Plant::three_groups)) {
    samples = plant == Plant::forgotten_rule ? all : parted(all, 3);
    mesh = mesh_of(Resampled(*subject.domain, samples), subject.lattice, method, plant);
  } else {
    mesh = mesh_of(*subject.domain, subject.lattice, method, plant);
  }
  Verdict verdict;
  verdict.tets = mesh.tets.size();
  std::string fault = topology::surface_fault(mesh);
  const topology::Shape shape = topology::of_samples(
      vertices_of(subject.lattice), [&](Coord3 v) { return samples.contains(v); });
  verdict.pieces = shape.pieces;
  verdict.tunnels = shape.tunnels;
  verdict.cavities = shape.cavities;
  if (fault.empty()) fault = shape_fault(mesh, shape, subject.pieces);
  std::vector<exact::Tet> tets;
  for (const auto& [a, b, c, d] : mesh.tets)
    tets.push_back({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]});
  const exact::AngleRange& range =
      method == certet::Method::key ? exact::key_range : exact::angles_range;
  if (fault.empty()) fault = tet_fault(tets, range, verdict);
  if (!fault.empty()) verdict.fault = fault;
  return verdict;
}

}  // namespace thin
