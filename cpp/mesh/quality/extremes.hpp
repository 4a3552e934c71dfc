#pragma once
/// \file
/// From the quantities that are added up exactly to those that people read.

#include <cmath>
#include <numbers>

#include "certet/quality.hpp"

namespace certet::core {

/// The angle in degrees of which cot |cot| is given.
inline double degrees_of(double signed_squared_cotangent) {
  const double cotangent =
      std::copysign(std::sqrt(std::fabs(signed_squared_cotangent)), signed_squared_cotangent);
  return std::atan2(1.0, cotangent) * (180 / std::numbers::pi);
}

inline void set_extremes(Quality& quality) {
  quality.min_dihedral = degrees_of(quality.sharpest);
  quality.max_dihedral = degrees_of(quality.bluntest);
}

/// A volume given as six times its measure in steps cubed.
inline double long_edges_cubed(const WideSum& steps_volume) {
  return std::ldexp(steps_volume.value(), -3 * (step_bits + 1)) / 6;
}

}  // namespace certet::core
