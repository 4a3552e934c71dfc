#include "certet/count_pieces.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "boundary.hpp"
#include "engine/disjoint_sets.hpp"
#include "faces.hpp"
#include "surface_faults.hpp"

namespace certet {
namespace {

using core::for_runs;
using core::Groups;
using core::stop_now_and_then;

/// The faces of a mesh are brought together in so many rounds, to hold fewer at a time.
constexpr std::uint64_t face_rounds = 4;
/// In each their groups are sorted by so many tasks.
constexpr std::uint64_t face_sorting_tasks = 16;

/// A face in the group of its lowest point.
template <class Number>
struct TetFace {
  Number middle, highest, tet;
  friend auto operator<=>(const TetFace&, const TetFace&) = default;
  [[nodiscard]] bool same_points(const TetFace& other) const {
    return middle == other.middle && highest == other.highest;
  }
};

/// `Number` counts points, and tetrahedra.
template <class Index, class Number>
class FacePieces {
 public:
  FacePieces(std::span<const Point3> points, std::span<const Tet<Index>> tets,
              std::span<const std::int32_t> labels, Context& context)
      : points_(points), tets_(tets), labels_(labels), context_(context), whole_(tets.size()),
        of_labels_(labels.empty() ? 0 : tets.size()), of_points_(points.size()), told_(points.size()) {}

  Pieces count() {
    for (std::size_t i = 0; i < tets_.size(); ++i)
      if (is_valid(i)) order_.push_back(static_cast<Number>(i));
    join_faces();
    Pieces found;
    found.whole = {count_sets(whole_, order_), count_by_points(order_)};
    found.largest = largest();
    if (!labels_.empty()) found.regions = regions();
    found.surface = core::find_surface_faults(surface_, points_, context_);
    return found;
  }

 private:
  using Face = TetFace<Number>;
  using Sets = DisjointSetsOf<Number>;

  [[nodiscard]] bool is_valid(std::size_t tet) const {
    Tet<Index> p = tets_[tet];
    std::ranges::sort(p);
    return p[3] < points_.size() && std::ranges::adjacent_find(p) == p.end();
  }

  static Face face(std::uint64_t middle, std::uint64_t highest, Number tet) {
    return {static_cast<Number>(middle), static_cast<Number>(highest), tet};
  }

  void join_faces() {
    const std::uint64_t step = points_.size() / face_rounds + 1;
    for (std::uint64_t begin = 0; begin < points_.size(); begin += step)
      join_faces(begin, std::min<std::uint64_t>(begin + step, points_.size()));
  }

  /// Calls take(lowest point, face) for those whose lowest points are [begin, end).
  template <class Take>
  void for_each_face(std::uint64_t begin, std::uint64_t end, const Take& take) const {
    for (const Number i : order_) {
      stop_now_and_then(i, context_);
      const auto p = core::sorted(tets_[i]).points;
      if (begin <= p[0] && p[0] < end) {
        take(p[0], face(p[1], p[2], i));
        take(p[0], face(p[1], p[3], i));
        take(p[0], face(p[2], p[3], i));
      }
      if (begin <= p[1] && p[1] < end) take(p[1], face(p[2], p[3], i));
    }
  }

  void join_faces(std::uint64_t begin, std::uint64_t end) {
    Groups<Face> faces(end - begin);
    for_each_face(begin, end, [&](std::uint64_t p, const Face&) { faces.count(p - begin); });
    faces.lay_out();
    for_each_face(begin, end,
                  [&](std::uint64_t p, const Face& face) { faces.place(p - begin, face); });
    core::parallel_for(context_, Stage::count, face_sorting_tasks, [&](std::int64_t task) {
      const std::size_t size = faces.size() / face_sorting_tasks + 1;
      const std::size_t first = static_cast<std::size_t>(task) * size;
      for (std::size_t n = first; n < std::min(first + size, faces.size()); ++n)
        core::sort_group(faces[n]);
    });
    for (std::size_t n = 0; n < faces.size(); ++n) {
      stop_now_and_then(n, context_);
      for_runs(faces[n], [](const Face& a, const Face& b) { return a.same_points(b); },
               [&](std::span<Face> run) { join(begin + n, run); });
    }
  }

  /// The tetrahedra of one face.
  void join(std::uint64_t lowest, std::span<Face> run) {
    if (run.size() == 1) surface_.push_back(outward(lowest, run.front()));
    for (std::size_t n = 1; n < run.size(); ++n) whole_.join(run.front().tet, run[n].tet);
    if (labels_.empty() || run.size() == 1) return;
    const auto label = [this](const Face& face) { return labels_[face.tet]; };
    std::ranges::sort(run, {}, label);
    for (std::size_t n = 1; n < run.size(); ++n)
      if (label(run[n - 1]) == label(run[n])) of_labels_.join(run[n - 1].tet, run[n].tet);
  }

  /// As seen from outside.
  [[nodiscard]] core::Triangle outward(std::uint64_t lowest, const Face& face) const {
    const Tet<Index>& tet = tets_[face.tet];
    std::uint8_t opposite = 0;
    while (tet[opposite] == lowest || tet[opposite] == face.middle || tet[opposite] == face.highest)
      ++opposite;
    return core::face_of(tet, face.tet, opposite).points;
  }

  [[nodiscard]] static std::uint64_t count_sets(Sets& sets, std::span<const Number> tets) {
    return static_cast<std::uint64_t>(
        std::ranges::count_if(tets, [&](Number i) { return sets.find(i) == i; }));
  }

  [[nodiscard]] std::uint64_t largest() {
    std::vector<Number> tets(tets_.size());
    for (const Number i : order_) ++tets[whole_.find(i)];
    return tets.empty() ? 0 : *std::ranges::max_element(tets);
  }

  static Number number(Index point) { return static_cast<Number>(point); }

  /// Each point is a piece at first, and each tetrahedron joins its own.
  std::uint64_t count_by_points(std::span<const Number> some) {
    for (const Number i : some)
      for (const Index p : tets_[i]) of_points_.take_out(number(p));
    for (const Number i : some)
      for (const Index p : tets_[i]) of_points_.join(number(tets_[i][0]), number(p));
    // The least point of a piece is one of a tetrahedron, and is told once.
    std::uint64_t pieces = 0;
    for (const Number i : some)
      for (const Index p : tets_[i])
        if (of_points_.find(number(p)) == p && !told_[p]) {
          told_[p] = true;
          ++pieces;
        }
    for (const Number i : some)
      for (const Index p : tets_[i]) told_[p] = false;
    return pieces;
  }

  std::vector<RegionPieces> regions() {
    std::ranges::stable_sort(order_, {}, [&](Number i) { return labels_[i]; });
    std::vector<RegionPieces> regions;
    for_runs(std::span(order_), [&](Number a, Number b) { return labels_[a] == labels_[b]; },
             [&](std::span<Number> run) {
               regions.push_back({labels_[run.front()],
                                  {count_sets(of_labels_, run), count_by_points(run)}});
             });
    return regions;
  }

  std::span<const Point3> points_;
  std::span<const Tet<Index>> tets_;
  std::span<const std::int32_t> labels_;
  Context& context_;
  std::vector<Number> order_;  ///< the tetrahedra with good indices
  Sets whole_, of_labels_;
  Sets of_points_;
  std::vector<bool> told_;  ///< points
  std::vector<core::Triangle> surface_;
};

template <class Index>
Pieces pieces_of(std::span<const Point3> points, std::span<const Tet<Index>> tets,
                 std::span<const std::int32_t> labels, Context& context) {
  if (std::max(points.size(), tets.size()) <= std::numeric_limits<std::uint32_t>::max())
    return FacePieces<Index, std::uint32_t>(points, tets, labels, context).count();
  return FacePieces<Index, std::uint64_t>(points, tets, labels, context).count();
}

}  // namespace

Pieces count_pieces(std::span<const Point3> points, std::span<const Tet<std::uint32_t>> tets,
                    std::span<const std::int32_t> labels, Context& context) {
  return pieces_of(points, tets, labels, context);
}

Pieces count_pieces(std::span<const Point3> points, std::span<const Tet<std::uint64_t>> tets,
                    std::span<const std::int32_t> labels, Context& context) {
  return pieces_of(points, tets, labels, context);
}

Pieces count_pieces(const Mesh& mesh, Context& context) {
  const Buffer<Point3> world = world_points(mesh);
  return std::visit(
      [&]<class Index>(const Buffer<Tet<Index>>& tets) {
        return pieces_of<Index>(world, tets, mesh.labels, context);
      },
      mesh.tets);
}

}  // namespace certet
