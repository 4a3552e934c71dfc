#pragma once
/// \file
/// Where the picture is taken from.

#include <span>

#include "vector.hpp"

namespace certet::view {

/// A place on the canvas, in pixels from the left and the top, and how near it
/// is: 1 in the middle of the mesh, more in front of it.
struct OnCanvas {
  float x, y, nearness;
};

/// In perspective, its up being the world's z.  Takes points that were moved and
/// scaled to lie around the origin, within a ball of radius 1.
class Camera {
 public:
  /// `toward_eye` points from the mesh to the viewer.
  explicit Camera(Vec toward_eye);

  /// Chooses scale and middle so that all points are in the rectangle.
  void fit(std::span<const Vec> points, float left, float top, float width, float height);

  [[nodiscard]] OnCanvas project(Vec point) const;
  /// A direction seen from the eye: x to the right, y up, z toward the eye.
  [[nodiscard]] Vec turn(Vec direction) const;

 private:
  static constexpr float distance = 4.5F;

  Vec right_, up_, back_;
  float scale_ = 1, middle_x_ = 0, middle_y_ = 0;
};

}  // namespace certet::view
