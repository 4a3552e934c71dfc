#include "palette.hpp"

#include <algorithm>
#include <cmath>

namespace certet::view {
namespace {

// Chosen to differ in lightness as well as in hue.
constexpr std::array<Rgb, hues> regions_apart{{{0x6f, 0xa8, 0xdc},
                                            {0xf0, 0x90, 0x6a},
                                            {0xf1, 0xdd, 0x85},
                                            {0x4f, 0xb9, 0x9b},
                                            {0xf4, 0xa9, 0xbd},
                                            {0xb5, 0xc4, 0x4a},
                                            {0xa5, 0x8f, 0xd0},
                                            {0x9f, 0xda, 0xf2}}};

// Diverging, without a pair of red and green.
constexpr std::array<Rgb, 7> from_bad_to_good{{{0xa5, 0x00, 0x26},
                                               {0xdd, 0x3d, 0x2d},
                                               {0xf6, 0x7e, 0x4b},
                                               {0xfe, 0xda, 0x8b},
                                               {0xea, 0xec, 0xcc},
                                               {0x98, 0xca, 0xe1},
                                               {0x4a, 0x7b, 0xb7}}};

// Darker and darker.
constexpr std::array<Rgb, 6> from_near_to_far{{{0xf7, 0xf4, 0xd0},
                                               {0xfa, 0xc8, 0x6e},
                                               {0xf0, 0x86, 0x4a},
                                               {0xc8, 0x3f, 0x5a},
                                               {0x80, 0x20, 0x70},
                                               {0x2c, 0x12, 0x50}}};

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
