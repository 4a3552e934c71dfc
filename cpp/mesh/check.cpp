#include "certet/check.hpp"

#include <cmath>
#include <utility>

#include "certet/placed_quality.hpp"
#include "faces.hpp"
#include "judge.hpp"
#include "ranges.hpp"

namespace certet {
namespace core {

std::string count_of(std::uint64_t number, const std::string& singular,
                     const std::string& plural) {
  return std::to_string(number) + " " + (number == 1 ? singular : plural);
}

}  // namespace core

namespace {

using core::count_of;
using core::EdgeFindings;
using core::Face;
using core::FaceFindings;

std::string name_of(const Face& face) {
  return "with the points " + std::to_string(face.points[0]) + ", " +
         std::to_string(face.points[1]) + " and " + std::to_string(face.points[2]);
}

/// A count, and the number of the first that was counted.
struct Offenders {
  std::uint64_t count = 0, first = 0;
  void add(std::uint64_t number) {
    if (count++ == 0) first = number;
  }
};

template <class Index>
class Check {
 public:
  Check(std::span<const Point3> points, std::span<const Tet<Index>> tets, Context& context)
      : points_(points), tets_(tets), context_(context) {}

  /// Of a mesh of which nothing is known.
  CheckReport report() { return report(find_faces(), measure_all()); }

  CheckReport report(const FaceFindings& faces, const Quality& quality) {
    report_.points = points_.size();
    report_.quality = quality;
    if (tets_.empty()) fail("there are no tetrahedra");
    for (const auto step : {&Check::check_indices, &Check::check_use, &Check::check_places,
                            &Check::check_volumes}) {
      core::stop_now_and_then(0, context_);
      (this->*step)();
    }
    check_faces(faces);
    return std::move(report_);
  }

 private:
  [[nodiscard]] bool valid(std::size_t tet) const {
    const auto& [a, b, c, d] = tets_[tet];
    const std::size_t n = points_.size();
    return a < n && b < n && c < n && d < n && a != b && a != c && a != d && b != c && b != d &&
           c != d;
  }

  void fail(std::string sentence) { report_.failures.push_back(std::move(sentence)); }

  void check_indices();
  void check_use();
  void check_places();
  void check_volumes();
  void check_faces(const FaceFindings& faces);
  [[nodiscard]] FaceFindings find_faces() const;
  [[nodiscard]] Quality measure_all() const;
  [[nodiscard]] Quality measure(std::size_t begin, std::size_t end) const;

  std::span<const Point3> points_;
  std::span<const Tet<Index>> tets_;
  Context& context_;
  CheckReport report_;
};

template <class Index>
void Check<Index>::check_indices() {
  Offenders bad;
  for (std::size_t i = 0; i < tets_.size(); ++i)
    if (!valid(i)) bad.add(i);
  report_.bad_indices = bad.count;
  if (bad.count > 0)
    fail(count_of(bad.count, "tetrahedron names", "tetrahedra name") +
         " a point that is not there, or one point twice, the first being number " +
         std::to_string(bad.first));
}

template <class Index>
void Check<Index>::check_use() {
  std::vector<bool> used(points_.size());
  for (std::size_t i = 0; i < tets_.size(); ++i)
    if (valid(i))
      for (const Index point : tets_[i]) used[point] = true;
  Offenders unused;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i]) unused.add(i);
  report_.unused_points = unused.count;
  if (unused.count > 0)
    fail(count_of(unused.count, "point is", "points are") +
         " in no tetrahedron, the first being number " + std::to_string(unused.first));
}

template <class Index>
void Check<Index>::check_places() {
  Offenders nonfinite;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (!is_finite(points_[i])) nonfinite.add(i);
  report_.nonfinite_points = nonfinite.count;
  if (nonfinite.count > 0)
    fail(count_of(nonfinite.count, "point is", "points are") +
         " not finite, the first being number " + std::to_string(nonfinite.first));

  report_.duplicate_points = count_coincident(points_);
  if (report_.duplicate_points > 0)
    fail(count_of(report_.duplicate_points, "point is", "points are") +
         " at the very place of another");
}

/// Of the tetrahedra [begin, end): between those that name no points, runs of
/// those that do.
template <class Index>
Quality Check<Index>::measure(std::size_t begin, std::size_t end) const {
  Quality quality;
  while (begin < end) {
    std::size_t stop = begin;
    while (stop < end && valid(stop)) ++stop;
    if (stop > begin) quality += measure_world(points_, 0, tets_.subspan(begin, stop - begin));
    begin = stop + 1;
  }
  return quality;
}

template <class Index>
Quality Check<Index>::measure_all() const {
  const auto parts =
      core::in_ranges(tets_.size(), core::tets_per_task, Stage::count, context_,
                      [&](std::size_t begin, std::size_t end) { return measure(begin, end); });
  Quality quality;
  for (const Quality& part : parts) quality += part;
  return quality;
}

template <class Index>
void Check<Index>::check_volumes() {
  if (report_.quality.nonpositive > 0)
    fail(count_of(report_.quality.nonpositive, "tetrahedron has", "tetrahedra have") +
         " a volume that is not positive");
}

template <class Index>
FaceFindings Check<Index>::find_faces() const {
  const auto is_valid = [this](std::size_t tet) { return valid(tet); };
  return points_.size() <= core::NarrowFace::point_limit
             ? core::find_faces<core::NarrowFace>(points_.size(), tets_, is_valid, context_)
             : core::find_faces<core::WideFace>(points_.size(), tets_, is_valid, context_);
}

template <class Index>
void Check<Index>::check_faces(const FaceFindings& faces) {
  const EdgeFindings edges = core::find_edges(points_.size(), faces.boundary, context_);
  report_.overfull_faces = faces.overfull;
  report_.misoriented_faces = faces.misoriented;
  report_.boundary_faces = faces.boundary.size();
  report_.open_edges = edges.open;
  if (faces.first_overfull)
    fail(count_of(faces.overfull, "face is", "faces are") +
         " in three or more tetrahedra, the first being the one " +
         name_of(*faces.first_overfull));
  if (faces.first_misoriented)
    fail(count_of(faces.misoriented, "inner face is", "inner faces are") +
         " seen the same way round from both sides, the first being the one " +
         name_of(*faces.first_misoriented));
  if (edges.first_open)
    fail("the boundary is not closed and oriented at " +
         count_of(edges.open, "edge", "edges") + ", the first being from point " +
         std::to_string((*edges.first_open)[0]) + " to point " +
         std::to_string((*edges.first_open)[1]));
}

}  // namespace

template <class Index>
CheckReport core::judge(std::span<const Point3> points, std::span<const Tet<Index>> tets,
                        const FaceFindings& faces, const Quality& quality, Context& context) {
  return Check<Index>(points, tets, context).report(faces, quality);
}

template CheckReport core::judge(std::span<const Point3>, std::span<const Tet<std::uint32_t>>,
                                 const FaceFindings&, const Quality&, Context&);
template CheckReport core::judge(std::span<const Point3>, std::span<const Tet<std::uint64_t>>,
                                 const FaceFindings&, const Quality&, Context&);

CheckReport check(std::span<const Point3> points, std::span<const Tet<std::uint32_t>> tets,
                  Context& context) {
  return Check<std::uint32_t>(points, tets, context).report();
}

CheckReport check(std::span<const Point3> points, std::span<const Tet<std::uint64_t>> tets,
                  Context& context) {
  return Check<std::uint64_t>(points, tets, context).report();
}

CheckReport check(const Mesh& mesh, Context& context) {
  const Buffer<Point3> world = world_points(mesh);
  return std::visit(
      [&]<class Index>(const Buffer<Tet<Index>>& tets) {
        return check(world, std::span<const Tet<Index>>(tets), context);
      },
      mesh.tets);
}

}  // namespace certet
