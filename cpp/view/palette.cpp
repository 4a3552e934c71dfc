#include "palette.hpp"

#include <algorithm>
#include <cmath>

namespace certet::view {
namespace {

/// As web pages write it, 0xRRGGBB.
constexpr Rgb rgb(std::uint32_t number) {
  return {static_cast<std::uint8_t>(number >> 16), static_cast<std::uint8_t>(number >> 8),
          static_cast<std::uint8_t>(number)};
}

// Chosen to differ in lightness as well as in hue.
constexpr std::array<Rgb, hues> regions_apart{
    rgb(0x6fa8dc), rgb(0xf0906a), rgb(0xf1dd85), rgb(0x4fb99b),
    rgb(0xf4a9bd), rgb(0xb5c44a), rgb(0xa58fd0), rgb(0x9fdaf2)};

// Diverging, without a pair of red and green.
constexpr std::array<Rgb, 7> from_bad_to_good{
    rgb(0xa50026), rgb(0xdd3d2d), rgb(0xf67e4b), rgb(0xfeda8b),
    rgb(0xeaeccc), rgb(0x98cae1), rgb(0x4a7bb7)};

// Darker and darker.
constexpr std::array<Rgb, 6> from_near_to_far{
    rgb(0xf7f4d0), rgb(0xfac86e), rgb(0xf0864a), rgb(0xc83f5a),
    rgb(0x802070), rgb(0x2c1250)};

std::uint8_t blend(std::uint8_t a, std::uint8_t b, double share) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * share));
}

Rgb blend(const Rgb& a, const Rgb& b, double share) {
  return {blend(a[0], b[0], share), blend(a[1], b[1], share), blend(a[2], b[2], share)};
}

/// `scaled` from 0 at the first color to 1 at the last; what is beyond, and NaN, is at an end.
template <std::size_t count>
Rgb along(const std::array<Rgb, count>& colors, double scaled) {
  const double at = scaled > 0 ? std::min(scaled * (count - 1), double(count - 1)) : 0;
  const std::size_t below = std::min(static_cast<std::size_t>(at), count - 2);
  return blend(colors[below], colors[below + 1], at - static_cast<double>(below));
}

}  // namespace

Rgb region_color(std::size_t hue, std::size_t shade) {
  constexpr std::array<double, 3> dark{0, 0.22, 0.11};
  return blend(regions_apart[hue], Rgb{0x30, 0x34, 0x50}, dark[shade % dark.size()]);
}

// A flat tetrahedron's angle is not a number.
Rgb angle_color(double worst_angle) { return along(from_bad_to_good, worst_angle / best_angle); }

Rgb distance_color(double share) { return along(from_near_to_far, share); }

}  // namespace certet::view
