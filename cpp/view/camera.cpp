#include "camera.hpp"

#include <algorithm>
#include <limits>

namespace certet::view {

Camera::Camera(Vec toward_eye)
    : right_(unit(cross({0, 0, 1}, toward_eye))),
      up_(unit(cross(toward_eye, right_))),
      back_(unit(toward_eye)) {}

void Camera::fit(std::span<const Vec> points, float left, float top, float width, float height) {
  scale_ = 1;
  middle_x_ = middle_y_ = 0;
  constexpr float far = std::numeric_limits<float>::infinity();
  float x0 = far, x1 = -far, y0 = far, y1 = -far;
  for (const Vec& point : points) {
    const OnCanvas at = project(point);
    x0 = std::min(x0, at.x), x1 = std::max(x1, at.x);
    y0 = std::min(y0, at.y), y1 = std::max(y1, at.y);
  }
  constexpr float least = 1e-6F;
  scale_ = std::min(width / std::max(x1 - x0, least), height / std::max(y1 - y0, least));
  middle_x_ = left + width / 2 - scale_ * (x0 + x1) / 2;
  middle_y_ = top + height / 2 - scale_ * (y0 + y1) / 2;
}

OnCanvas Camera::project(Vec point) const {
  const Vec seen = turn(point);
  const float nearness = distance / (distance - seen.z);
  return {middle_x_ + scale_ * seen.x * nearness, middle_y_ - scale_ * seen.y * nearness, nearness};
}

Vec Camera::turn(Vec direction) const {
  return {dot(right_, direction), dot(up_, direction), dot(back_, direction)};
}

}  // namespace certet::view
