#pragma once
/// \file
/// A canvas with a depth for each sample, on which triangles are drawn.

#include <array>
#include <cstdint>
#include <vector>

#include "camera.hpp"
#include "certet/picture.hpp"
#include "vector.hpp"

namespace certet::view {

/// Light in linear red, green and blue.
using Light = Vec;

/// How a line along an edge is drawn.
struct DrawnEdge {
  float dark = 0;   ///< 0 to 1
  float width = 0.75F;  ///< on its side of the edge, in pixels
};

/// A triangle on the canvas, with normals as Camera::turn gives them.
struct DrawnTriangle {
  std::array<OnCanvas, 3> corners;
  std::array<Vec, 3> normals;
  Light color;
  std::array<DrawnEdge, 3> edges;  ///< across from each corner
};

class Canvas {
 public:
  /// Pixels; there are 2x2 samples in each.
  Canvas(int width, int height);

  /// Coordinates are those of pixels.
  void draw(const DrawnTriangle& triangle);

  /// Shades what lies deeper than what is around, and lays it on the ground.
  [[nodiscard]] Picture develop() const;

 private:
  static constexpr int samples = 2;  ///< along each side of a pixel
  static constexpr float nothing = 0;

  struct Pixels;
  [[nodiscard]] Pixels average() const;

  int width_, height_;      ///< pixels
  std::vector<float> nearness_;  ///< of each sample; 0 where nothing is drawn
  std::vector<Light> light_;
};

}  // namespace certet::view
