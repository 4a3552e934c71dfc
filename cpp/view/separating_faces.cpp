#include "separating_faces.hpp"

#include <algorithm>
#include <compare>

#include "certet/tet_shape.hpp"
#include "mesh/boundary.hpp"
#include "mesh/faces.hpp"
#include "mesh/groups.hpp"

namespace certet::view {
namespace {

/// A face of a tetrahedron in the group of its lowest point.
struct FaceKey {
  std::uint64_t middle, highest, tet;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy takes the comparison with 0 for a pointer's
  friend auto operator<=>(const FaceKey&, const FaceKey&) = default;
  [[nodiscard]] bool same_points(const FaceKey& other) const {
    return middle == other.middle && highest == other.highest;
  }
};

std::uint64_t mixed(std::uint64_t a, std::uint64_t b, std::uint64_t sides) {
  std::uint64_t h = a * 0x9e3779b97f4a7c15 ^ (b + sides) * 0xc2b2ae3d27d4eb4f;
  h ^= h >> 29;
  h *= 0xbf58476d1ce4e5b9;
  return h ^ h >> 32;
}

/// The four faces of a tetrahedron as work(lowest, middle, highest).
template <class Work>
void for_faces(const Tet<std::uint64_t>& tet, Work work) {
  const auto p = core::sorted(tet).points;
  work(p[0], p[1], p[2]);
  work(p[0], p[1], p[3]);
  work(p[0], p[2], p[3]);
  work(p[1], p[2], p[3]);
}

class Search {
 public:
  Search(const FileMesh& mesh, const Planes& planes, bool labels)
      : mesh_(mesh), planes_(planes), labels_(labels && !mesh.labels.empty()) {}

  std::vector<SeparatingFace> run() {
    mark();
    gather();
    return pair_up();
  }

 private:
  /// The label of a tetrahedron, where it matters.
  [[nodiscard]] std::int32_t label(std::uint64_t tet) const {
    return labels_ ? mesh_.labels[tet] : 0;
  }

  /// A face that two tetrahedra on the same side share leaves no trace in the
  /// sum at its lowest point; so where the sum is zero there is nothing to see.
  void mark() {
    marks_.assign(mesh_.points.size(), 0);
    for (std::uint64_t i = 0; i < mesh_.tets.size(); ++i) {
      if (!has_corners(mesh_.points, mesh_.tets[i])) continue;
      const auto [x, y, z] = sides_of(mesh_, i, planes_);
      const std::uint64_t sides =
          (std::uint64_t{x} << 56 | std::uint64_t{y} << 48 | std::uint64_t{z} << 40) +
          static_cast<std::uint32_t>(label(i)) * 0x9e3779b97f4a7c15;
      for_faces(mesh_.tets[i], [&](std::uint64_t low, std::uint64_t middle, std::uint64_t high) {
        marks_[low] ^= mixed(middle, high, sides);
      });
    }
  }

  template <class Work>
  void for_candidates(Work work) {
    for (std::uint64_t i = 0; i < mesh_.tets.size(); ++i) {
      const auto& tet = mesh_.tets[i];
      const auto marked = [this](std::uint64_t p) { return p < marks_.size() && marks_[p] != 0; };
      if (std::ranges::none_of(tet, marked) || !has_corners(mesh_.points, tet)) continue;
      for_faces(tet, [&](std::uint64_t low, std::uint64_t middle, std::uint64_t high) {
        if (marks_[low] != 0) work(low, FaceKey{middle, high, i});
      });
    }
  }

  void gather() {
    for_candidates([this](std::uint64_t low, const FaceKey&) { by_lowest_.count(low); });
    by_lowest_.lay_out();
    for_candidates([this](std::uint64_t low, const FaceKey& key) { by_lowest_.place(low, key); });
  }

  std::vector<SeparatingFace> pair_up() {
    std::vector<SeparatingFace> found;
    const auto same = [](const FaceKey& a, const FaceKey& b) { return a.same_points(b); };
    for (std::size_t lowest = 0; lowest < by_lowest_.size(); ++lowest) {
      const std::span<FaceKey> group = by_lowest_[lowest];
      core::sort_group(group);
      core::for_runs(group, same, [&](std::span<FaceKey> run) {
        const std::uint64_t tet = run.front().tet;
        const std::uint64_t other = run.size() > 1 ? run[1].tet : no_tet;
        if (other != no_tet && label(tet) == label(other) &&
            sides_of(mesh_, tet, planes_) == sides_of(mesh_, other, planes_))
          return;
        found.push_back({turned_outward(tet, lowest, run.front()), tet, other});
      });
    }
    return found;
  }

  [[nodiscard]] std::array<std::uint64_t, 3> turned_outward(std::uint64_t number,
                                                            std::uint64_t lowest,
                                                            const FaceKey& key) const {
    const auto& tet = mesh_.tets[number];
    const auto on_face = [&](std::uint64_t p) {
      return p == lowest || p == key.middle || p == key.highest;
    };
    std::size_t across = 0;
    while (across < 3 && on_face(tet[across])) ++across;
    const auto [a, b, c] = core::outward_faces[across];
    return {tet[a], tet[b], tet[c]};
  }

  const FileMesh& mesh_;
  const Planes& planes_;
  bool labels_;
  std::vector<std::uint64_t> marks_;
  core::Groups<FaceKey> by_lowest_{mesh_.points.size()};
};

}  // namespace

Planes::Planes(const Point3& low, const Point3& high, const std::array<int, 3>& count)
    : count_(count) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    count_[axis] = std::clamp(count_[axis], 0, most);
    gap_[axis] = (high[axis] - low[axis]) / (count_[axis] + 1);
    first_[axis] = low[axis] + gap_[axis];
    per_length_[axis] = gap_[axis] > 0 ? 1 / gap_[axis] : 0;
  }
}

Planes Planes::single(int axis, double place) {
  Planes planes;
  const auto a = static_cast<std::size_t>(axis);
  planes.count_[a] = 1;
  planes.first_[a] = place;
  // Whatever lies behind is at least one step behind.
  planes.per_length_[a] = 0;
  return planes;
}

double Planes::place(int axis, int plane) const {
  const auto a = static_cast<std::size_t>(axis);
  return first_[a] + plane * gap_[a];
}

std::vector<SeparatingFace> separating_faces(const FileMesh& mesh, const Planes& planes,
                                             BetweenLabels between) {
  return Search(mesh, planes, between == BetweenLabels::found).run();
}

}  // namespace certet::view
