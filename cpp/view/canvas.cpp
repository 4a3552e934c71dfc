#include "canvas.hpp"

#include <algorithm>
#include <cmath>

#include "blur.hpp"
#include "palette.hpp"

namespace certet::view {
namespace {

constexpr Light edge_color{0.02F, 0.025F, 0.04F};

/// The light that a surface sends to the eye: a lamp from above on the left, a
/// weak one from the right, the sky, and a rim where it turns away.
Light lit(Light color, Vec normal) {
  const Vec n = normal.z < 0 ? -1.0F * normal : normal;
  static const Vec key = unit({-0.45F, 0.65F, 0.75F});
  static const Vec fill = unit({0.8F, 0.05F, 0.5F});
  const float diffuse = 0.78F * std::max(dot(n, key), 0.0F) + 0.20F * std::max(dot(n, fill), 0.0F);
  const float sky = 0.20F + 0.10F * n.y;
  const float away = 1 - n.z;
  const float rim = 0.10F * away * away * away;
  return (diffuse + sky) * color + Light{rim, rim, rim};
}

Light mix(Light a, Light b, float share) { return a + share * (b - a); }

std::uint8_t encode(float linear) {
  const float bounded = std::clamp(linear, 0.0F, 1.0F);
  const float srgb = bounded <= 0.0031308F ? 12.92F * bounded
                                           : 1.055F * std::pow(bounded, 1 / 2.4F) - 0.055F;
  return static_cast<std::uint8_t>(std::lround(255 * srgb));
}

/// Twice the area of the triangle, positive if it turns left on the canvas.
float turn(const OnCanvas& a, const OnCanvas& b, float x, float y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

float length(const OnCanvas& a, const OnCanvas& b) { return std::hypot(b.x - a.x, b.y - a.y); }

}  // namespace

/// What is left of the samples of each pixel.
struct Canvas::Pixels {
  std::vector<Light> light;     ///< sum over the covered samples, divided by all
  std::vector<float> cover;     ///< the share of the covered samples
  std::vector<float> nearness;  ///< mean, the ground being as deep as the deepest
};

Canvas::Canvas(int width, int height)
    : width_(width), height_(height),
      nearness_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * samples *
                samples, nothing),
      light_(nearness_.size()) {}

void Canvas::draw(const DrawnTriangle& triangle) {
  std::array<OnCanvas, 3> c = triangle.corners;
  for (OnCanvas& corner : c) corner.x *= samples, corner.y *= samples;
  const float area = turn(c[0], c[1], c[2].x, c[2].y);
  if (area == 0 || !std::isfinite(area)) return;
  const int wide = width_ * samples, high = height_ * samples;
  const auto [x0, x1] = std::minmax({c[0].x, c[1].x, c[2].x});
  const auto [y0, y1] = std::minmax({c[0].y, c[1].y, c[2].y});
  const int left = std::max(static_cast<int>(std::ceil(x0 - 0.5F)), 0);
  const int right = std::min(static_cast<int>(std::floor(x1 - 0.5F)), wide - 1);
  const int top = std::max(static_cast<int>(std::ceil(y0 - 0.5F)), 0);
  const int bottom = std::min(static_cast<int>(std::floor(y1 - 0.5F)), high - 1);
  // The altitudes turn shares into distances from the edges, in samples.
  const std::array<float, 3> altitude{std::fabs(area) / length(c[1], c[2]),
                                      std::fabs(area) / length(c[2], c[0]),
                                      std::fabs(area) / length(c[0], c[1])};
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      const float px = static_cast<float>(x) + 0.5F, py = static_cast<float>(y) + 0.5F;
      const float s0 = turn(c[1], c[2], px, py) / area, s1 = turn(c[2], c[0], px, py) / area;
      const float s2 = 1 - s0 - s1;
      if (s0 < 0 || s1 < 0 || s2 < 0) continue;
      const float nearness = s0 * c[0].nearness + s1 * c[1].nearness + s2 * c[2].nearness;
      const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(wide) +
                             static_cast<std::size_t>(x);
      if (nearness <= nearness_[at]) continue;
      nearness_[at] = nearness;
      const auto& n = triangle.normals;
      const Light light = lit(triangle.color, unit(s0 * n[0] + s1 * n[1] + s2 * n[2]));
      const std::array<float, 3> off{s0 * altitude[0], s1 * altitude[1], s2 * altitude[2]};
      float dark = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& [darkness, width] = triangle.edges[i];
        dark = std::max(dark, darkness * std::clamp(samples * width - off[i], 0.0F, 1.0F));
      }
      light_[at] = mix(light, edge_color, dark);
    }
}

Canvas::Pixels Canvas::average() const {
  const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  float deepest = 1e30F;
  for (const float nearness : nearness_)
    if (nearness != nothing) deepest = std::min(deepest, nearness);
  Pixels result{std::vector<Light>(pixels), std::vector<float>(pixels),
                std::vector<float>(pixels)};
  constexpr float share = 1.0F / (samples * samples);
  const auto wide = static_cast<std::size_t>(width_) * samples;
  for (std::size_t at = 0; at < nearness_.size(); ++at) {
    const std::size_t x = at % wide / samples, y = at / wide / samples;
    const std::size_t pixel = y * static_cast<std::size_t>(width_) + x;
    const bool covered = nearness_[at] != nothing;
    if (covered) result.light[pixel] = result.light[pixel] + share * light_[at];
    if (covered) result.cover[pixel] += share;
    result.nearness[pixel] += share * (covered ? nearness_[at] : deepest);
  }
  return result;
}

Picture Canvas::develop() const {
  const Pixels pixels = average();
  const int smaller = std::min(width_, height_);
  const std::vector<float> close = blurred(pixels.nearness, width_, std::max(smaller / 160, 1));
  const std::vector<float> wide = blurred(pixels.nearness, width_, std::max(smaller / 24, 1));
  Picture picture{width_, height_, std::vector<std::uint8_t>(3 * pixels.cover.size())};
  for (std::size_t i = 0; i < pixels.cover.size(); ++i) {
    const float near_deep = std::max(close[i] - pixels.nearness[i], 0.0F);
    const float wide_deep = std::max(wide[i] - pixels.nearness[i], 0.0F);
    const float shade = std::exp(-28 * near_deep - 7 * wide_deep);
    const std::size_t row = i / static_cast<std::size_t>(width_);
    const float y = static_cast<float>(row) / static_cast<float>(height_);
    const Light ground = std::exp(-0.9F * wide_deep) *
                         mix({0.98F, 0.985F, 0.99F}, {0.84F, 0.86F, 0.89F}, y * y);
    const Light light = shade * pixels.light[i] + (1 - pixels.cover[i]) * ground;
    picture.rgb[3 * i] = encode(light.x);
    picture.rgb[3 * i + 1] = encode(light.y);
    picture.rgb[3 * i + 2] = encode(light.z);
  }
  return picture;
}

}  // namespace certet::view
