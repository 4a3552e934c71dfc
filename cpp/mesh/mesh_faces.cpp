#include "mesh_faces.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "parts.hpp"

namespace certet::core {
namespace {

/// The faces of a mesh are brought together in so many rounds, to hold fewer at a time.
constexpr std::uint64_t face_rounds = 4;
/// In each their groups are sorted by so many tasks.
constexpr std::uint64_t face_sorting_tasks = 16;

/// A face of a tetrahedron in the group of its lowest point.
template <class Number>
struct TetFace {
  Number middle, highest_and_side, tet;

  TetFace() = default;
  TetFace(std::uint64_t middle_point, std::uint64_t highest, bool reversed, Number of)
      : middle(static_cast<Number>(middle_point)),
        highest_and_side(static_cast<Number>(highest << 1 | (reversed ? 1 : 0))), tet(of) {}
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy takes the comparison with 0 for a pointer's
  friend auto operator<=>(const TetFace&, const TetFace&) = default;
  [[nodiscard]] std::uint64_t highest() const { return highest_and_side >> 1; }
  [[nodiscard]] bool reversed() const { return (highest_and_side & 1) != 0; }
  [[nodiscard]] bool same_points(const TetFace& other) const {
    return middle == other.middle && highest() == other.highest();
  }
  [[nodiscard]] core::Face face(std::uint64_t lowest) const {
    return {{lowest, middle, highest()}, reversed()};
  }
};

/// `Number` counts twice the points, and tetrahedra.
template <class Index, class Number>
class FaceSearch {
 public:
  FaceSearch(std::uint64_t points, std::span<const Tet<Index>> tets,
             std::span<const std::int32_t> labels, Context& context)
      : points_(points), tets_(tets), labels_(labels), context_(context), parts_(tets, labels) {}

  MeshFaces run() {
    for (std::size_t i = 0; i < tets_.size(); ++i)
      if (is_valid(i)) order_.push_back(static_cast<Number>(i));
    const std::uint64_t step = points_ / face_rounds + 1;
    for (std::uint64_t begin = 0; begin < points_; begin += step)
      look_at(begin, std::min(begin + step, points_));
    std::ranges::sort(found_.misoriented);
    found_.pieces = parts_.count(points_, order_);
    return std::move(found_);
  }

 private:
  using Key = TetFace<Number>;

  [[nodiscard]] bool is_valid(std::size_t tet) const {
    Tet<Index> p = tets_[tet];
    std::ranges::sort(p);
    return p[3] < points_ && std::ranges::adjacent_find(p) == p.end();
  }

  /// Calls take(lowest point, key) for the faces whose lowest points are [begin, end).
  template <class Take>
  void for_each_face(std::uint64_t begin, std::uint64_t end, const Take& take) const {
    for (const Number i : order_) {
      stop_now_and_then(i, context_);
      // The boundary of (p0 p1 p2 p3) is the alternating sum of its faces.
      const auto [p, odd] = sorted(tets_[i]);
      if (begin <= p[0] && p[0] < end) {
        take(p[0], Key(p[1], p[2], !odd, i));
        take(p[0], Key(p[1], p[3], odd, i));
        take(p[0], Key(p[2], p[3], !odd, i));
      }
      if (begin <= p[1] && p[1] < end) take(p[1], Key(p[2], p[3], odd, i));
    }
  }

  /// The faces whose lowest points are [begin, end).
  void look_at(std::uint64_t begin, std::uint64_t end) {
    Groups<Key> faces(end - begin);
    for_each_face(begin, end, [&](std::uint64_t p, const Key&) { faces.count(p - begin); });
    faces.lay_out();
    for_each_face(begin, end, [&](std::uint64_t p, const Key& key) { faces.place(p - begin, key); });
    parallel_for(context_, Stage::count, face_sorting_tasks, [&](std::int64_t task) {
      const std::size_t size = faces.size() / face_sorting_tasks + 1;
      const std::size_t first = static_cast<std::size_t>(task) * size;
      for (std::size_t n = first; n < std::min(first + size, faces.size()); ++n)
        sort_group(faces[n]);
    });
    for (std::size_t n = 0; n < faces.size(); ++n) {
      stop_now_and_then(n, context_);
      for_runs(faces[n], [](const Key& a, const Key& b) { return a.same_points(b); },
               [&](std::span<Key> run) { look_at(begin + n, run); });
    }
  }

  /// The tetrahedra of one face.
  void look_at(std::uint64_t lowest, std::span<Key> run) {
    if (run.size() == 1) {
      found_.outer.push_back(seen_of(lowest, run.front()));
    } else if (run.size() == 2) {
      if (run[0].reversed() == run[1].reversed() && found_.findings.misoriented++ == 0)
        found_.findings.first_misoriented = run[0].face(lowest);
      if (!parts_.join(run[0].tet, run[1].tet)) add_between(lowest, run);
    } else {
      if (found_.findings.overfull++ == 0) found_.findings.first_overfull = run[0].face(lowest);
      std::ranges::sort(run, {}, [this](const Key& key) { return parts_.label(key.tet); });
      for (std::size_t n = 1; n < run.size(); ++n) parts_.join(run[n - 1].tet, run[n].tet);
    }
  }

  void add_between(std::uint64_t lowest, std::span<Key> run) {
    if (parts_.label(run[1].tet) < parts_.label(run[0].tet)) std::swap(run[0], run[1]);
    found_.between.push_back({seen_of(lowest, run[0]), parts_.label(run[1].tet)});
    if (run[0].reversed() == run[1].reversed())
      found_.misoriented.push_back(found_.between.back().face.points);
  }

  [[nodiscard]] BoundaryFace seen_of(std::uint64_t lowest, const Key& key) const {
    const Tet<Index>& tet = tets_[key.tet];
    std::uint8_t opposite = 0;
    while (tet[opposite] == lowest || tet[opposite] == key.middle || tet[opposite] == key.highest())
      ++opposite;
    return face_of(tet, key.tet, opposite,
                   labels_.empty() ? only_label : labels_[key.tet]);
  }

  std::uint64_t points_;
  std::span<const Tet<Index>> tets_;
  std::span<const std::int32_t> labels_;
  Context& context_;
  std::vector<Number> order_;  ///< the tetrahedra with good indices
  Parts<Index, Number> parts_;
  MeshFaces found_;
};

template <class Index>
MeshFaces faces_of(std::uint64_t points, std::span<const Tet<Index>> tets,
                   std::span<const std::int32_t> labels, Context& context) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  if (2 * points <= most && tets.size() <= most)
    return FaceSearch<Index, std::uint32_t>(points, tets, labels, context).run();
  return FaceSearch<Index, std::uint64_t>(points, tets, labels, context).run();
}

}  // namespace

MeshFaces find_mesh_faces(std::uint64_t points, std::span<const Tet<std::uint32_t>> tets,
                          std::span<const std::int32_t> labels, Context& context) {
  return faces_of(points, tets, labels, context);
}

MeshFaces find_mesh_faces(std::uint64_t points, std::span<const Tet<std::uint64_t>> tets,
                          std::span<const std::int32_t> labels, Context& context) {
  return faces_of(points, tets, labels, context);
}

}  // namespace certet::core
