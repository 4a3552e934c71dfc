#include "edge_in_cell.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "fields/cell_corners.hpp"

namespace certet::fields {
namespace {

/// Between two steps and at neither.
std::int32_t on_line(std::int32_t low, std::int64_t at_low, std::int32_t high,
                     std::int64_t at_high) {
  const std::int64_t away = (high - low) * at_low / (at_low - at_high);
  return std::clamp(low + static_cast<std::int32_t>(away), low + 1, high - 1);
}

/// What a trilinear function is along a line, by powers of the steps.
class Cubic {
 public:
  /// `first` and `along` are in 2^20ths; values in 2^20ths of a field's unit.
  Cubic(const Corners& corner, const std::array<std::int64_t, 3>& first,
        const std::array<std::int64_t, 3>& along) {
    constexpr double unit = 1.0 / static_cast<double>(point_one), step = unit / steps;
    std::array<double, 3> from, by;
    for (std::size_t a = 0; a < 3; ++a) {
      from[a] = unit * static_cast<double>(first[a]);
      by[a] = step * static_cast<double>(along[a]);
    }
    std::array<double, 4> x0, x1;  // between corners 2c and 2c + 1: x0 + x1 s
    for (std::size_t c = 0; c < 4; ++c) {
      const double low = static_cast<double>(point_one) * corner[2 * c];
      const double rise = static_cast<double>(point_one) * (corner[2 * c + 1] - corner[2 * c]);
      x0[c] = low + rise * from[0];
      x1[c] = rise * by[0];
    }
    std::array<double, 2> y0, y1, y2;
    for (std::size_t c = 0; c < 2; ++c) {
      const double rise0 = x0[2 * c + 1] - x0[2 * c], rise1 = x1[2 * c + 1] - x1[2 * c];
      y0[c] = x0[2 * c] + rise0 * from[1];
      y1[c] = x1[2 * c] + rise1 * from[1] + rise0 * by[1];
      y2[c] = rise1 * by[1];
    }
    const double rise0 = y0[1] - y0[0], rise1 = y1[1] - y1[0], rise2 = y2[1] - y2[0];
    power_ = {y0[0] + rise0 * from[2], y1[0] + rise1 * from[2] + rise0 * by[2],
              y2[0] + rise2 * from[2] + rise1 * by[2], rise2 * by[2]};
  }

  [[nodiscard]] double at(double s) const {
    return power_[0] + s * (power_[1] + s * (power_[2] + s * power_[3]));
  }
  [[nodiscard]] double slope(double s) const {
    return power_[1] + s * (2 * power_[2] + s * (3 * power_[3]));
  }
  /// The greatest of the coefficients of the slope as a Bernstein polynomial between two steps:
  /// it is nowhere steeper upwards.
  [[nodiscard]] double greatest_slope(double low, double high) const {
    const double at_low = slope(low);
    const double middle = at_low + (high - low) * (power_[2] + low * (3 * power_[3]));
    return std::max({at_low, middle, slope(high)});
  }

 private:
  std::array<double, 4> power_;
};

/// In the first of all.
void keep_greatest(Eight& values) {
  const auto mix = [&values](const Eight& other) {
    values = values > other ? values : other;
  };
  mix(__builtin_shufflevector(values, values, 4, 5, 6, 7, 0, 1, 2, 3));
  mix(__builtin_shufflevector(values, values, 2, 3, 0, 1, 6, 7, 4, 5));
  mix(__builtin_shufflevector(values, values, 1, 0, 3, 2, 5, 4, 7, 6));
}

/// By how much `EdgeInCell::at` may differ from the cubic: its points are rounded by less than
/// one unit along each axis, its values by less than two, and the doubles here by next to nothing.
double rounding(const Corners& corner) {
  Eight at;
  std::memcpy(&at, &corner, sizeof(at));
  Eight along_x = at - __builtin_shufflevector(at, at, 1, 0, 3, 2, 5, 4, 7, 6);
  Eight along_y = at - __builtin_shufflevector(at, at, 2, 3, 0, 1, 6, 7, 4, 5);
  Eight along_z = at - __builtin_shufflevector(at, at, 4, 5, 6, 7, 0, 1, 2, 3);
  // Of the two ends of an edge of the cell one is the upper: of an axis' eight the greatest is
  // the steepest edge's.
  keep_greatest(along_x);
  keep_greatest(along_y);
  keep_greatest(along_z);
  return 4.0 + along_x[0] + along_y[0] + along_z[0];
}

}  // namespace

std::int32_t EdgeInCell::root(std::int32_t low, std::int32_t high) const {
  const auto only = only_root(low, high);
  return only ? *only : root_by_lines(low, high);
}

/// Where the cubic is beyond the rounding, its sign is the difference's.  Where it is not, and
/// falls by twice the rounding from each step to the next, there is one step at most.
std::optional<std::int32_t> EdgeInCell::only_root(std::int32_t low, std::int32_t high) const {
  constexpr int most_rounds = 6;
  const Cubic cubic(difference_, first_, along_);
  const double off = rounding(difference_);
  const double at_low = cubic.at(low), at_high = cubic.at(high);
  if (!(at_low > off && at_high < -off)) return std::nullopt;
  const double fall = -cubic.greatest_slope(low, high);
  if (!(fall > 2 * off)) return std::nullopt;
  double s = low + (high - low) * at_low / (at_low - at_high);
  for (int round = 0; round < most_rounds; ++round) {
    const double value = cubic.at(s);
    s = std::clamp<double>(s - value / cubic.slope(s), low, high);
    if (std::abs(value) < fall) break;
  }
  auto step = std::min(static_cast<std::int32_t>(s), high - 1);
  if (cubic.at(step) > off && cubic.at(step + 1) < -off) return step;
  while (step > low && at(step) <= 0) --step;
  while (step + 1 < high && at(step + 1) > 0) ++step;
  return step;
}

/// Mostly where a straight line through the values at both ends has its root, for that is near.
std::int32_t EdgeInCell::root_by_lines(std::int32_t low, std::int32_t high) const {
  constexpr int most_lines = 8;
  std::int64_t at_low = at(low), at_high = at(high);
  if (at_low <= 0) return low;
  if (at_high > 0) return high - 1;
  for (int round = 0; high - low > 1; ++round) {
    const std::int32_t step = round < most_lines ? on_line(low, at_low, high, at_high)
                                                 : low + (high - low) / 2;
    const std::int64_t value = at(step);
    (value > 0 ? low : high) = step;
    (value > 0 ? at_low : at_high) = value;
  }
  return low;
}

}  // namespace certet::fields
