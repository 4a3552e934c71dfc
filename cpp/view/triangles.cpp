#include "triangles.hpp"

#include <limits>

#include "certet/tet_shape.hpp"

namespace certet::view {
namespace {

class Hull {
 public:
  void add(const Point3& point) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box_.low[axis] = std::min(box_.low[axis], point[axis]);
      box_.high[axis] = std::max(box_.high[axis], point[axis]);
    }
  }
  [[nodiscard]] Box box() const { return box_; }

 private:
  static constexpr double far = std::numeric_limits<double>::infinity();
  Box box_{{far, far, far}, {-far, -far, -far}};
};

}  // namespace

void PointSubset::number() {
  number_.assign(used_.size(), 0);
  for (std::uint64_t point = 0; point < used_.size(); ++point) {
    if (!used_[point]) continue;
    number_[point] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(point);
  }
}

Box box_of(const FileMesh& mesh, std::span<const SeparatingFace> faces) {
  Hull hull;
  for (const SeparatingFace& face : faces)
    for (const std::uint64_t point : face.points) hull.add(mesh.points[point]);
  return hull.box();
}

Box box_of(const FileMesh& mesh) {
  Hull hull;
  for (const auto& tet : mesh.tets)
    if (has_corners(mesh.points, tet))
      for (const std::uint64_t point : tet) hull.add(mesh.points[point]);
  return hull.box();
}

}  // namespace certet::view
