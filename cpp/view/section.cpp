#include "section.hpp"

#include <algorithm>
#include <span>

#include "certet/tet_shape.hpp"
#include "mesh/groups.hpp"

namespace certet::view {
namespace {

using FacePoints = std::array<std::uint64_t, 3>;

/// A side of a polygon, and the face of the mesh that it lies in.
struct Side {
  FacePoints face;
  std::size_t polygon;
  std::size_t side;
};

FacePoints sorted(FacePoints face) {
  std::ranges::sort(face);
  return face;
}

class Sections {
 public:
  Sections(const FileMesh& mesh, const CutPlane& plane) : mesh_(mesh), plane_(plane) {}

  std::vector<SectionPolygon> run() {
    for (std::uint64_t tet = 0; tet < mesh_.tets.size(); ++tet)
      if (has_corners(mesh_.points, mesh_.tets[tet])) cut(tet);
    find_rims();
    return std::move(polygons_);
  }

 private:
  void cut(std::uint64_t tet) {
    // The corners that are kept come first.
    Tet<std::uint64_t> p = mesh_.tets[tet];
    const auto gone = std::stable_partition(
        p.begin(), p.end(), [this](std::uint64_t i) { return plane_.keeps(mesh_.points[i]); });
    const auto kept = static_cast<std::size_t>(gone - p.begin());
    if (kept == 1) add(tet, {{{p[0], p[1]}, {p[0], p[2]}, {p[0], p[3]}}}, 3);
    if (kept == 2) add(tet, {{{p[0], p[2]}, {p[0], p[3]}, {p[1], p[3]}, {p[1], p[2]}}}, 4);
    if (kept == 3) add(tet, {{{p[0], p[3]}, {p[1], p[3]}, {p[2], p[3]}}}, 3);
  }

  /// Corners lie on edges, from a point that is kept to one that is not; neighbours have a
  /// point in common.
  void add(std::uint64_t tet, const std::array<std::array<std::uint64_t, 2>, 4>& edges,
           std::size_t corners) {
    SectionPolygon polygon{tet, corners, {}, {}};
    for (std::size_t n = 0; n < corners; ++n) {
      const auto& [kept, gone] = edges[n];
      const auto& [next_kept, next_gone] = edges[(n + 1) % corners];
      polygon.places[n] = plane_.crossing(mesh_.points[kept], mesh_.points[gone]);
      sides_.push_back({sorted({kept, gone, kept == next_kept ? next_gone : next_kept}),
                        polygons_.size(), n});
    }
    polygons_.push_back(polygon);
  }

  void find_rims() {
    std::ranges::sort(sides_, {}, &Side::face);
    core::for_runs(std::span(sides_),
                   [](const Side& a, const Side& b) { return a.face == b.face; },
                   [this](std::span<Side> run) {
                     if (run.size() == 2 && label(run[0]) == label(run[1])) return;
                     for (const Side& side : run) polygons_[side.polygon].is_rim[side.side] = true;
                   });
  }

  [[nodiscard]] std::int32_t label(const Side& side) const {
    return mesh_.labels.empty() ? 0 : mesh_.labels[polygons_[side.polygon].tet];
  }

  const FileMesh& mesh_;
  const CutPlane& plane_;
  std::vector<SectionPolygon> polygons_;
  std::vector<Side> sides_;
};

}  // namespace

Point3 CutPlane::crossing(const Point3& kept, const Point3& gone) const {
  const double a = behind(kept), b = behind(gone);
  const double share = a / (a - b);
  Point3 at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = kept[i] + share * (gone[i] - kept[i]);
  at[static_cast<std::size_t>(axis)] = place;
  return at;
}

std::vector<SectionPolygon> section(const FileMesh& mesh, const CutPlane& plane) {
  return Sections(mesh, plane).run();
}

}  // namespace certet::view
