#include "scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "certet/tet_shape.hpp"
#include "coarse_surface.hpp"
#include "packing.hpp"
#include "palette.hpp"
#include "triangles.hpp"

namespace certet::view {
namespace {

/// How far tetrahedra reach along each axis, on average over some of them.
Point3 mean_extents(const FileMesh& mesh) {
  constexpr std::uint64_t some = 50'000;
  const std::uint64_t step = mesh.tets.size() / some + 1;
  Point3 sum{};
  std::uint64_t count = 0;
  for (std::uint64_t i = 0; i < mesh.tets.size(); i += step) {
    if (!has_corners(mesh.points, mesh.tets[i])) continue;
    const auto& [a, b, c, d] = mesh.tets[i];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] =
          std::minmax({mesh.points[a][axis], mesh.points[b][axis], mesh.points[c][axis],
                       mesh.points[d][axis]});
      sum[axis] += high - low;
    }
    ++count;
  }
  for (double& extent : sum) extent /= static_cast<double>(std::max<std::uint64_t>(count, 1));
  return sum;
}

/// As many planes as the limits allow.  Across a face the centroids move by about
/// a quarter of what tetrahedra reach, so each of the two faces there are for a
/// tetrahedron crosses a plane with that chance.
Planes choose_planes(const FileMesh& mesh, const Box& box, const SceneLimits& limits) {
  const Point3 extents = mean_extents(mesh);
  double faces = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double length = box.high[axis] - box.low[axis];
    if (length > 0)
      faces += 2 * static_cast<double>(mesh.tets.size()) * extents[axis] / 4 / length;
  }
  const double wish = static_cast<double>(limits.cut_triangles) / std::max(faces, 1.0);
  const int count = static_cast<int>(std::clamp<double>(wish, 1, limits.planes));
  // An odd number has a plane in the middle.
  const int odd = count % 2 == 0 ? count - 1 : count;
  return {box.low, box.high, {odd, odd, odd}};
}

/// A face between two labels as the tetrahedron of the lesser has it.
SeparatingFace of_lesser(const FileMesh& mesh, SeparatingFace face) {
  if (mesh.labels[face.tet] < mesh.labels[face.other]) return face;
  std::swap(face.tet, face.other);
  std::swap(face.points[1], face.points[2]);
  return face;
}

class Packer {
 public:
  Packer(const FileMesh& mesh, const Regions& regions, const SceneLimits& limits)
      : mesh_(mesh), regions_(regions) {
    scene_.box = box_of(mesh);
    scene_.planes = choose_planes(mesh, scene_.box, limits);
    std::vector<SeparatingFace> sheets;
    for (const SeparatingFace& face :
         separating_faces(mesh, scene_.planes, BetweenLabels::found)) {
      const bool border = face.other == no_tet, between = is_between_labels(mesh, face);
      if (border) ++scene_.border_faces;
      if (between) ++scene_.interface_faces;
      if (border || between) sheets.push_back(between ? of_lesser(mesh, face) : face);
      if (!border && sides_of(mesh, face.tet, scene_.planes) !=
                         sides_of(mesh, face.other, scene_.planes))
        inner_.push_back(face);
    }
    surface_ = coarse_surface(mesh, sheets, limits.surface_triangles);
    scene_.surface_triangles = surface_.triangles.size();
    scene_.coarse = surface_.cell;
  }

  Scene run() {
    for (const SeparatingFace& face : inner_) subset_.add(face.points);
    subset_.number();
    pack_points();
    pack_surface();
    for (int axis = 0; axis < 3; ++axis)
      for (int plane = 0; plane < scene_.planes.count(axis); ++plane) pack_cut(axis, plane);
    scene_.data = packing_.base64();
    return std::move(scene_);
  }

 private:
  /// Those of the cuts first, then those of the surface.
  void pack_points() {
    packing_.natural(subset_.points().size() + surface_.points.size());
    std::array<std::int64_t, 3> last{};
    const auto pack = [&](const Point3& point) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t place =
            std::llround((point[axis] - scene_.box.low[axis]) / scene_.box.width() * 65535);
        packing_.integer(place - last[axis]);
        last[axis] = place;
      }
    };
    for (const std::uint64_t point : subset_.points()) pack(mesh_.points[point]);
    for (const Point3& point : surface_.points) pack(point);
  }

  void pack_surface() {
    packing_.natural(surface_.triangles.size());
    start_triangles();
    const auto first = static_cast<std::uint32_t>(subset_.points().size());
    for (const CoarseTriangle& triangle : surface_.triangles) {
      const auto& [a, b, c] = triangle.points;
      pack_triangle(first + a, first + b, first + c);
      pack_region(triangle.tet);
      packing_.integer(triangle.other == no_tet ? 0 : 1 + region(triangle.other));
      packing_.byte(angle(triangle.tet));
      for (const std::uint8_t side : sides_of(mesh_, triangle.tet, scene_.planes))
        packing_.byte(side);
    }
  }

  void pack_cut(int axis, int plane) {
    Packing head;
    std::swap(head, packing_);
    start_triangles();
    std::uint64_t count = 0;
    const auto a = static_cast<std::size_t>(axis);
    for (const SeparatingFace& face : inner_) {
      const int one = sides_of(mesh_, face.tet, scene_.planes)[a];
      const int other = sides_of(mesh_, face.other, scene_.planes)[a];
      if ((one > plane) == (other > plane)) continue;
      ++count;
      const bool first_below = one <= plane;
      const std::uint64_t below = first_below ? face.tet : face.other;
      const std::uint64_t above = first_below ? face.other : face.tet;
      const auto& [p, q, r] = face.points;
      pack_triangle(subset_[p], subset_[first_below ? q : r], subset_[first_below ? r : q]);
      pack_region(below);
      packing_.integer(region(above) - region(below));
      packing_.byte(angle(below));
      packing_.byte(angle(above));
    }
    std::swap(head, packing_);
    packing_.natural(count);
    packing_.append(head);
    scene_.cut_triangles += count;
  }

  void start_triangles() { last_point_ = last_region_ = 0; }

  void pack_triangle(std::int64_t a, std::int64_t b, std::int64_t c) {
    packing_.integer(a - last_point_);
    packing_.integer(b - a);
    packing_.integer(c - a);
    last_point_ = a;
  }

  void pack_region(std::uint64_t tet) {
    const std::int64_t place = region(tet);
    packing_.integer(place - last_region_);
    last_region_ = place;
  }

  [[nodiscard]] std::int64_t region(std::uint64_t tet) const {
    return static_cast<std::int64_t>(regions_.place(mesh_, tet));
  }

  [[nodiscard]] std::uint8_t angle(std::uint64_t tet) const {
    const auto& [a, b, c, d] = mesh_.tets[tet];
    const auto& p = mesh_.points;
    const double share = shape_of({p[a], p[b], p[c], p[d]}).worst_angle() / best_angle;
    return share > 0 ? static_cast<std::uint8_t>(std::lround(255 * std::min(share, 1.0))) : 0;
  }

  const FileMesh& mesh_;
  const Regions& regions_;
  Scene scene_;
  std::vector<SeparatingFace> inner_;
  CoarseSurface surface_;
  PointSubset subset_{mesh_.points.size()};
  Packing packing_;
  std::int64_t last_point_ = 0, last_region_ = 0;
};

}  // namespace

Scene make_scene(const FileMesh& mesh, const Regions& regions, const SceneLimits& limits) {
  return Packer(mesh, regions, limits).run();
}

}  // namespace certet::view
