#pragma once
/// \file
/// Where a point lies with respect to the domain.

#include <cstdint>

namespace certet {

/// Outside (-), on the boundary (0), inside (+): `Sign` of the certificate.
enum class Sign : std::uint8_t { minus = 0, on_surface = 1, plus = 2 };

constexpr bool opposite(Sign a, Sign b) {
  return a != Sign::on_surface && b != Sign::on_surface && a != b;
}

/// The sign of what is inside (`plus`) or on the surface (`zero`), or neither.
constexpr Sign sign_of_bits(int plus, int zero) {
  return static_cast<Sign>(2 * plus + zero);  // no branches: loops vectorise
}

/// The sign of a level function that is negative inside; NaN counts as outside.
constexpr Sign sign_of_level(double f) {
  return sign_of_bits(int{f < 0}, int{f == 0});
}

}  // namespace certet
