#pragma once
/// \file
/// Angles by sums, products, quotients and square roots alone, so that they are the same
/// numbers on every machine: an arctangent of the system's library need not be.

#include <algorithm>
#include <array>
#include <cmath>

namespace certet {

/// The arctangent of a t from 0 to 1, in turns, within 1e-14: the addition theorem with the
/// nearest quarter, then the series.
inline double arctangent_in_turns(double t) {
  constexpr double turn = 6.283185307179586476925;
  constexpr std::array<double, 5> of_quarters{0, 0.2449786631268641541721, 0.4636476090008061162143,
                                              0.6435011087932843868028, 0.7853981633974483096157};
  const auto quarter = static_cast<std::size_t>(4 * t + 0.5);
  const double near = 0.25 * static_cast<double>(quarter);
  const double rest = (t - near) / (1 + t * near), square = rest * rest;
  double sum = 0;
  for (int n = 13; n > 0; n -= 2) sum = 1.0 / n - square * sum;
  return (of_quarters[quarter] + rest * sum) / turn;
}

/// The angle of the point (x, y) seen from the origin, in turns, from -1/2 to 1/2; 0 of
/// the origin.
inline double angle_in_turns(double y, double x) {
  const double far = std::max(std::abs(x), std::abs(y)), near = std::min(std::abs(x), std::abs(y));
  if (far == 0) return 0;
  double angle = arctangent_in_turns(near / far);
  if (std::abs(y) > std::abs(x)) angle = 0.25 - angle;
  if (x < 0) angle = 0.5 - angle;
  return y < 0 ? -angle : angle;
}

}  // namespace certet
