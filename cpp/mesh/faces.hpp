#pragma once
/// \file
/// The faces of a mesh: which tetrahedra share them, and which are left over.

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "certet/context.hpp"
#include "certet/error.hpp"
#include "certet/mesh.hpp"
#include "engine/parallel.hpp"
#include "groups.hpp"

namespace certet::core {

/// A face seen from one of its tetrahedra: its points in growing order, and
/// whether that order runs against the orientation that the tetrahedron gives.
struct Face {
  std::array<std::uint64_t, 3> points;
  bool reversed;
};

/// A face in the group of its lowest point, in 8 bytes: for up to 2^31 points.
class NarrowFace {
 public:
  static constexpr std::uint64_t point_limit = std::uint64_t{1} << 31;

  NarrowFace() = default;
  NarrowFace(std::uint64_t middle, std::uint64_t highest, bool reversed)
      : bits_(middle << 32 | highest << 1 | (reversed ? 1 : 0)) {}
  [[nodiscard]] Face face(std::uint64_t lowest) const {
    return {{lowest, bits_ >> 32, (bits_ & 0xffffffff) >> 1}, (bits_ & 1) != 0};
  }
  [[nodiscard]] bool reversed() const { return (bits_ & 1) != 0; }
  [[nodiscard]] bool same_points(const NarrowFace& other) const {
    return bits_ >> 1 == other.bits_ >> 1;
  }
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy takes the comparison with 0 for a pointer's
  friend auto operator<=>(const NarrowFace&, const NarrowFace&) = default;

 private:
  std::uint64_t bits_;
};

/// The same in 16 bytes, for up to 2^63 points.
class WideFace {
 public:
  WideFace() = default;
  WideFace(std::uint64_t middle, std::uint64_t highest, bool reversed)
      : middle_(middle), rest_(highest << 1 | (reversed ? 1 : 0)) {}
  [[nodiscard]] Face face(std::uint64_t lowest) const {
    return {{lowest, middle_, rest_ >> 1}, reversed()};
  }
  [[nodiscard]] bool reversed() const { return (rest_ & 1) != 0; }
  [[nodiscard]] bool same_points(const WideFace& other) const {
    return middle_ == other.middle_ && rest_ >> 1 == other.rest_ >> 1;
  }
  // NOLINTNEXTLINE(modernize-use-nullptr): the same
  friend auto operator<=>(const WideFace&, const WideFace&) = default;

 private:
  std::uint64_t middle_, rest_;
};

/// What there is to be said of all faces.
struct FaceFindings {
  std::uint64_t overfull = 0;      ///< in three tetrahedra or more
  std::uint64_t misoriented = 0;   ///< in two that see it the same way round
  std::optional<Face> first_overfull, first_misoriented;
  std::vector<Face> boundary;      ///< in one tetrahedron

  /// Adds what was found further on.
  FaceFindings& operator+=(const FaceFindings& behind);
};

/// Looks at a context in the middle of long loops.  \throws Error `cancelled`.
inline void stop_now_and_then(std::size_t turn, const Context& context) {
  if (turn % (std::size_t{1} << 16) == 0) stop_if_cancelled(context);
}

/// What there is to be said of the edges of the boundary.
struct EdgeFindings {
  std::uint64_t open = 0;  ///< not run through as often forwards as backwards
  std::optional<std::array<std::uint64_t, 2>> first_open;
};

/// A tetrahedron's points in growing order.
struct SortedTet {
  std::array<std::uint64_t, 4> points;
  bool odd;  ///< whether sorting was an odd permutation
};

template <class Index>
SortedTet sorted(const Tet<Index>& tet) {
  SortedTet s{{tet[0], tet[1], tet[2], tet[3]}, false};
  const auto order = [&s](std::size_t i, std::size_t j) {
    const std::uint64_t low = std::min(s.points[i], s.points[j]);
    const std::uint64_t high = std::max(s.points[i], s.points[j]);
    s.odd ^= low != s.points[i];
    s.points[i] = low;
    s.points[j] = high;
  };
  order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
  return s;
}

/// Looks at the groups [begin, end) of faces with the same lowest point.
template <class FaceKey>
FaceFindings find_in_groups(Groups<FaceKey>& by_lowest, std::size_t begin, std::size_t end) {
  FaceFindings found;
  const auto same = [](const FaceKey& a, const FaceKey& b) { return a.same_points(b); };
  for (std::size_t lowest = begin; lowest < end; ++lowest) {
    const std::span<FaceKey> group = by_lowest[lowest];
    sort_group(group);
    for_runs(group, same, [&](std::span<FaceKey> run) {
      if (run.size() == 1) {
        found.boundary.push_back(run.front().face(lowest));
      } else if (run.size() > 2) {
        if (found.overfull++ == 0) found.first_overfull = run.front().face(lowest);
      } else if (run.front().reversed() == run.back().reversed()) {
        if (found.misoriented++ == 0) found.first_misoriented = run.front().face(lowest);
      }
    });
  }
  return found;
}

/// Brings together the faces of all tetrahedra for which `valid(number)`: those
/// name four different points below `points`.
/// \throws Error `cancelled`.
template <class FaceKey, class Index, class Valid>
FaceFindings find_faces(std::uint64_t points, std::span<const Tet<Index>> tets, Valid valid,
                        Context& context) {
  Groups<FaceKey> by_lowest(points);
  for (std::size_t i = 0; i < tets.size(); ++i) {
    stop_now_and_then(i, context);
    if (!valid(i)) continue;
    const auto [p, odd] = sorted(tets[i]);
    by_lowest.count(p[0], 3);
    by_lowest.count(p[1]);
  }
  by_lowest.lay_out();
  for (std::size_t i = 0; i < tets.size(); ++i) {
    stop_now_and_then(i, context);
    if (!valid(i)) continue;
    // The boundary of (p0 p1 p2 p3) is the alternating sum of its faces.
    const auto [p, odd] = sorted(tets[i]);
    by_lowest.place(p[1], {p[2], p[3], odd});
    by_lowest.place(p[0], {p[2], p[3], !odd});
    by_lowest.place(p[0], {p[1], p[3], odd});
    by_lowest.place(p[0], {p[1], p[2], !odd});
  }

  constexpr std::size_t groups_per_task = 1 << 15;
  const std::size_t tasks = (by_lowest.size() + groups_per_task - 1) / groups_per_task;
  std::vector<FaceFindings> parts(tasks);
  core::parallel_for(context, Stage::count, static_cast<std::int64_t>(tasks),
                     [&](std::int64_t task) {
                       const std::size_t begin = static_cast<std::size_t>(task) * groups_per_task;
                       parts[static_cast<std::size_t>(task)] = find_in_groups(
                           by_lowest, begin, std::min(begin + groups_per_task, by_lowest.size()));
                     });
  FaceFindings found;
  for (FaceFindings& part : parts) found += part;
  return found;
}

/// Brings together the edges of a surface of triangles.
/// \throws Error `cancelled`.
EdgeFindings find_edges(std::uint64_t points, std::span<const Face> surface, Context& context);

}  // namespace certet::core
