#pragma once
/// \file
/// Which of the eight octants around a point hang together.

#include <array>
#include <cstdint>

namespace certet::fields {

/// A bit for each octant; octant o lies on the upper side of axis a where bit a of o is
/// set.
using Octants = std::uint8_t;

namespace detail {
constexpr bool one_group(unsigned octants) {
  unsigned reached = octants & (~octants + 1);  // the lowest of them
  for (unsigned before = 0; before != reached;) {
    before = reached;
    for (unsigned o = 0; o < 8; ++o)
      if (reached >> o & 1) reached |= octants & (1U << (o ^ 1) | 1U << (o ^ 2) | 1U << (o ^ 4));
  }
  return reached == octants;
}

constexpr std::array<bool, 256> groups = [] {
  std::array<bool, 256> table{};
  for (unsigned octants = 0; octants < 256; ++octants) table[octants] = one_group(octants);
  return table;
}();
}  // namespace detail

/// Whether one can go from each to each across faces.
constexpr bool hang_together(Octants octants) { return detail::groups[octants]; }

/// Those on the upper side of axis 0, 1, 2.
inline constexpr std::array<Octants, 3> upper_octants{0xaa, 0xcc, 0xf0};

}  // namespace certet::fields
