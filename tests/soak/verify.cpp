#include "verify.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "certet/check.hpp"
#include "certet/checksum.hpp"
#include "certet/lattice/direction.hpp"
#include "certet/quality.hpp"
#include "certet/write_mesh.hpp"
#include "volume_estimate.hpp"

namespace soak {
namespace {

using certet::Coord3;
using certet::Point3;
using certet::Sign;
using NarrowTet = certet::Tet<std::uint32_t>;

/// A mesh that may be spoiled.
struct PlainMesh {
  std::vector<Coord3> points;
  std::vector<NarrowTet> tets;
  std::vector<std::int32_t> labels;
};

/// The domain, with everything outside beyond a plane.
class Half final : public certet::Domain {
 public:
  Half(const certet::Domain& whole, std::int32_t x) : whole_(whole), x_(x) {}
  void row(Coord3 first, std::span<Sign> out) const override {
    whole_.row(first, out);
    for (Sign& sign : out) {
      if (first.x > x_) sign = Sign::minus;
      first.x += 2;
    }
  }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    whole_.at(positions, out);
    for (std::size_t i = 0; i < out.size(); ++i)
      if (positions[i].x > certet::steps * x_) out[i] = Sign::minus;
  }

 private:
  const certet::Domain& whole_;
  std::int32_t x_;
};

PlainMesh in_memory(const certet::Stuffing& stuffing, const Trial& trial,
                    certet::Context& context) {
  const certet::Mesh made = certet::emit(stuffing, trial.frame, context);
  const auto& tets = std::get<certet::Buffer<NarrowTet>>(made.tets);
  return {{made.points.begin(), made.points.end()},
          {tets.begin(), tets.end()},
          {made.labels.begin(), made.labels.end()}};
}

void spoil(PlainMesh& mesh, Plant plant) {
  NarrowTet& tet = mesh.tets[mesh.tets.size() / 2];
  if (plant == Plant::flipped_tet) std::swap(tet[0], tet[1]);
  if (plant == Plant::missing_tet) tet = mesh.tets.back(), mesh.tets.pop_back();
  if (plant == Plant::moved_point) mesh.points[tet[2]] = mesh.points[tet[2]] + Coord3{200'000, 0, 0};
  if (plant == Plant::torn_point) {
    mesh.points.push_back(mesh.points[tet[1]]);
    tet[1] = static_cast<std::uint32_t>(mesh.points.size() - 1);
  }
  if (plant == Plant::swapped_labels)
    for (std::int32_t& label : mesh.labels) label = 4 - label;  // 1 for 3
}

/// Keeps what is written slab by slab.
class Keeper final : public certet::MeshWriter {
 public:
  void points(std::span<const Point3> points) override {
    points_.insert(points_.end(), points.begin(), points.end());
  }
  void tets(std::span<const NarrowTet> tets, std::span<const std::int32_t> labels) override {
    tets_.insert(tets_.end(), tets.begin(), tets.end());
    labels_.insert(labels_.end(), labels.begin(), labels.end());
  }
  void tets(std::span<const certet::Tet<std::uint64_t>>, std::span<const std::int32_t>) override {}
  void finish() override {}

  std::vector<Point3> points_;
  std::vector<NarrowTet> tets_;
  std::vector<std::int32_t> labels_;
};

/// Judges one mesh; every fault is a sentence.
class Judge {
 public:
  Judge(const Trial& trial, PlainMesh mesh, Verdict& verdict)
      : trial_(trial), mesh_(std::move(mesh)), verdict_(verdict) {
    for (const Coord3 p : mesh_.points) world_.push_back(trial.frame.world(p));
  }

  /// Conforming, closed, positive, every point used once: where the lattice has
  /// its points, and in the world.
  void check_soundness() {
    std::vector<Point3> exact;
    for (const Coord3 p : mesh_.points) exact.push_back({double(p.x), double(p.y), double(p.z)});
    for (const auto* points : {&exact, &world_})
      for (const std::string& failure : certet::check(*points, std::span<const NarrowTet>(mesh_.tets)).failures)
        fault((points == &exact ? "lattice: " : "world: ") + failure);
  }

  /// A hole inside is a closed boundary too; but it has faces with a vertex
  /// inside, where the surface cannot be.
  void check_cracks() {
    std::map<std::array<std::uint32_t, 3>, int> faces;
    for (const auto& [a, b, c, d] : mesh_.tets)
      for (std::array face : {std::array{b, c, d}, {a, c, d}, {a, b, d}, {a, b, c}}) {
        std::ranges::sort(face);
        ++faces[face];
      }
    std::vector<bool> on_boundary(mesh_.points.size());
    for (const auto& [face, sides] : faces)
      if (sides == 1)
        for (const std::uint32_t p : face) on_boundary[p] = true;
    for (std::size_t p = 0; p < on_boundary.size(); ++p)
      if (on_boundary[p] && is_inside(mesh_.points[p])) {
        fault("there is a crack at point " + std::to_string(p));
        return;
      }
  }

  void check_angles(certet::Method method) {
    const certet::AngleBounds& bounds = certet::facts(method).bounds;
    const std::span<const NarrowTet> tets(mesh_.tets);
    const certet::Quality lattice = certet::measure_lattice(mesh_.points, 0, tets);
    verdict_.min_dihedral = lattice.min_dihedral;
    verdict_.max_dihedral = lattice.max_dihedral;
    if (!certet::within(lattice, bounds, 1e-9)) fault("lattice: " + outside(lattice, bounds));
    const certet::Quality world = certet::measure_world(world_, 0, tets);
    if (!certet::within(world, bounds, 1e-6)) fault("world: " + outside(world, bounds));
    const double expected = lattice.volume * std::pow(trial_.frame.size, 3);
    if (std::abs(world.volume - expected) > 1e-6 * expected)
      fault("the volume of the world is not that of the lattice");
    volume_ = 8 * lattice.volume;
  }

  /// The volume against random points, in lattice units cubed, give or take some of
  /// what lies near the surface, that is within half an edge of it.  Shapes of which
  /// this is the better half need only have what lies deeper: between two layers of
  /// the lattice's points, at most sqrt(2) units apart, a sheet may vanish.
  void check_volume() {
    if (trial_.kind != Kind::smooth) return;
    verdict_.volume_compared = true;
    const VolumeEstimate estimate = estimate_volume(trial_);
    const double some = 0.1 * estimate.near, chance = 5 * estimate.deviation;
    verdict_.thin = 2 * estimate.deep < estimate.inside;
    const double least = (verdict_.thin ? estimate.deep : estimate.inside - some) - chance;
    const double most = estimate.inside + some + chance;
    if (!(least <= volume_ && volume_ <= most))
      fault("the volume is " + std::to_string(volume_) + " where " + std::to_string(estimate.inside) +
            " were estimated, and at least " + std::to_string(least) + " and at most " +
            std::to_string(most) + " are allowed");
  }

  /// A mesh may be empty only where no lattice point is inside with all its
  /// neighbours; those at the border of the lattice count as outside.
  void check_emptiness() {
    const auto& n = trial_.lattice.cells;
    const Coord3 odd{1, 1, 1};
    for (std::int32_t k = 2; k < n[2] - 2; ++k)
      for (std::int32_t j = 2; j < n[1] - 2; ++j)
        for (std::int32_t i = 2; i < n[0] - 2; ++i)
          for (const Coord3 parity : {Coord3{}, odd}) {
            const Coord3 point = trial_.lattice.origin + 2 * Coord3{i, j, k} + parity;
            if (!all_inside(star(certet::steps * point, certet::steps))) continue;
            fault("the mesh is empty where the domain is not");
            return;
          }
  }

  /// Written slab by slab the mesh is the same, down to its checksum.
  void check_stream(const certet::Stuffing& stuffing, Plant plant, certet::Context& context) {
    Keeper keeper;
    const std::uint64_t bytes = trial_.seed % 3 * 200'000;
    const certet::WrittenMesh written = certet::write_mesh(
        stuffing, trial_.frame, certet::cut_slabs(stuffing, bytes), keeper, context);
    if (plant == Plant::streamed_step) mesh_.points.back().y += 1;
    certet::Checksum sum;
    sum.points(0, mesh_.points);
    sum.tets(0, std::span<const NarrowTet>(mesh_.tets));
    if (written.checksum != sum.value()) fault("streamed: the checksum is another one");
    if (keeper.points_ != world_ || keeper.tets_ != mesh_.tets) fault("streamed: the mesh is another one");
    if (keeper.labels_ != mesh_.labels) fault("streamed: the labels are other ones");
  }

  /// Whether a label is at a point of the world or near it, in steps of a third of a size.
  [[nodiscard]] bool is_near(const Point3& at, std::int32_t label) const {
    const double step = trial_.frame.size / 3;
    for (int x = -3; x <= 3; ++x)
      for (int y = -3; y <= 3; ++y)
        for (int z = -3; z <= 3; ++z)
          if (trial_.labels.at({at[0] + step * x, at[1] + step * y, at[2] + step * z}) == label)
            return true;
    return false;
  }

  /// A tetrahedron has the label of the voxel that holds its centroid or, where labels are
  /// cut apart, of one within a size of it.
  void check_labels(bool cut_apart) {
    if (trial_.kind != Kind::labels) return;
    std::size_t wrong = 0, seen = 0;
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      const std::int32_t label = mesh_.labels[t];
      if (label < 1 || label > 3) ++wrong;
      Point3 centroid{0, 0, 0};
      for (const std::uint32_t p : mesh_.tets[t])
        for (std::size_t r = 0; r < 3; ++r) centroid[r] += world_[p][r] / 4;
      const std::optional<int> there = trial_.labels.at(centroid);
      if (!there || *there == 0) continue;
      ++seen;
      wrong += *there != label && !(cut_apart && is_near(centroid, label));
    }
    if (wrong > 0) fault(std::to_string(wrong) + " labels are not those of the voxels");
    if (seen == 0) fault("no label was looked at");
  }

 private:
  void fault(std::string sentence) { verdict_.faults.push_back(std::move(sentence)); }

  /// Whether a position is a lattice point that lies inside for certain: no edge
  /// is cut within its first step, so that it is not warped at distance 0 either.
  [[nodiscard]] bool is_inside(Coord3 position) const {
    const Coord3 d = position - certet::steps * trial_.lattice.origin;
    if ((d.x | d.y | d.z) & (certet::steps - 1)) return false;
    const std::array<std::int32_t, 3> index{d.x / certet::steps, d.y / certet::steps,
                                            d.z / certet::steps};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if ((index[axis] & 1) != (index[0] & 1)) return false;
      if (index[axis] / 2 < 1 || index[axis] / 2 > trial_.lattice.cells[axis] - 2) return false;
    }
    return all_inside(star(position, 1));
  }

  [[nodiscard]] bool all_inside(const Star& positions) const {
    std::array<Sign, std::tuple_size_v<Star>> signs;
    trial_.domain->at(positions, signs);
    return std::ranges::count(signs, Sign::minus) == 0 && signs[0] == Sign::plus;
  }

  static std::string outside(const certet::Quality& quality, const certet::AngleBounds& bounds) {
    return std::to_string(quality.nonpositive) + " tetrahedra are not positive, angles from " +
           std::to_string(quality.min_dihedral) + " to " + std::to_string(quality.max_dihedral) +
           " degrees, outside of " + std::string(bounds.theorem);
  }

  const Trial& trial_;
  PlainMesh mesh_;
  Verdict& verdict_;
  std::vector<Point3> world_;
  double volume_ = 0;
};

}  // namespace

Verdict verify(const Trial& trial, Plant plant) {
  Verdict verdict;
  verdict.kind = trial.kind;
  certet::Context context;
  context.threads = trial.threads;
  const Half half(*trial.domain, trial.lattice.origin.x + trial.lattice.cells[0]);
  const certet::Domain* meshed = trial.domain.get();
  if (plant == Plant::half_domain && trial.kind == Kind::smooth) meshed = &half;
  const Half none(*trial.domain, trial.lattice.origin.x - 1);
  if (plant == Plant::no_domain) meshed = &none;
  const certet::Stuffing stuffing(*meshed, trial.lattice, trial.method, context);
  verdict.tets = stuffing.tet_count();
  verdict.fell_back = stuffing.method() != trial.method;
  PlainMesh mesh = in_memory(stuffing, trial, context);
  if (verdict.tets > 0) spoil(mesh, plant);
  Judge judge(trial, std::move(mesh), verdict);
  if (verdict.tets == 0) {
    judge.check_emptiness();
    judge.check_volume();
    return verdict;
  }
  judge.check_soundness();
  if (plant != Plant::half_domain) judge.check_cracks();
  judge.check_angles(stuffing.method());
  judge.check_volume();
  judge.check_labels(stuffing.has_interfaces());
  judge.check_stream(stuffing, plant, context);
  return verdict;
}

}  // namespace soak
