#include "measurement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "extremes.hpp"

namespace certet::core {
namespace {

/// Beyond this cos |cos| the cosine tells angles apart no better than to
/// 1e-10 degrees: the careful way takes over.
constexpr double nearly_flat = 1 - 1e-8;

}  // namespace

bool ordinary(const TetBlock& block) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < lanes; ++i) {
    const double volume = block.six_volume[i];
    // No branches, so that the loop vectorises.
    count += int{volume > 0} & int{volume <= std::numeric_limits<double>::max()} &
             int{block.least_face[i] > 1e-140} & int{block.greatest_face[i] < 1e140} &
             int{block.greatest[i] <= nearly_flat} & int{block.least[i] >= -nearly_flat};
  }
  return count == lanes;
}

void Measurement::add_ordinary(const TetBlock& block) {
  const auto greater = [](double a, double b) { return a > b ? a : b; };
  const auto lesser = [](double a, double b) { return a < b ? a : b; };
  greatest_ = greater(greatest_, folded(block.greatest, greater));
  least_ = lesser(least_, folded(block.least, lesser));
  quality_.least_face = lesser(quality_.least_face, folded(block.least_face, lesser));
}

void Measurement::count_angles(TetBlock& block, std::size_t count, const Copies& counted) {
  if (!wants_histogram_) return;
  block.find_cells();
  for (std::size_t pair = 0; pair < histograms_.size(); ++pair)
    for (std::size_t i = 0; i < count; ++i)
      histograms_[pair][bins_.bin(block.signed_square[pair][i], block.cell[pair][i])] +=
          counted[i];
}

void Measurement::add_angles(const TetBlock& block, std::size_t lane) {
  const double greatest = block.greatest[lane], least = block.least[lane];
  if (greatest > nearly_flat || least < -nearly_flat)
    return add_extremes(
        CarefulTet(block.get(lane), block.six_volume[lane]).signed_squared_cotangents());
  if (greatest > greatest_) greatest_ = greatest;
  if (least < least_) least_ = least;
}

void Measurement::add_extremes(const std::array<double, 6>& signed_squared_cotangents) {
  for (const double value : signed_squared_cotangents) {
    quality_.sharpest = std::max(quality_.sharpest, value);
    quality_.bluntest = std::min(quality_.bluntest, value);
  }
}

void Measurement::add_careful(const CarefulTet& tet, std::uint64_t copies) {
  const auto values = tet.signed_squared_cotangents();
  add_extremes(values);
  if (!wants_histogram_) return;
  for (const double value : values) {
    // cos² = cot² / (1 + cot²), and 1 where the cotangent overflowed.
    const double square = 1 - 1 / (1 + std::fabs(value));
    const double signed_square = std::copysign(square, value);
    quality_.histogram[bins_.bin(signed_square, AngleBins::cell(signed_square))] += copies;
  }
}

Quality Measurement::result() {
  for (const auto& histogram : histograms_)
    for (std::size_t bin = 0; bin < histogram.size(); ++bin)
      quality_.histogram[bin] += histogram[bin];
  // cos² / sin² grows with cos² in floating point too, so that the greatest
  // cosine gives the greatest cotangent, whatever else was measured with it.
  const auto cotangent = [](double signed_square) {
    return signed_square / (1 - std::fabs(signed_square));
  };
  if (greatest_ > -1) quality_.sharpest = std::max(quality_.sharpest, cotangent(greatest_));
  if (least_ < 1) quality_.bluntest = std::min(quality_.bluntest, cotangent(least_));
  set_extremes(quality_);
  return quality_;
}

}  // namespace certet::core
