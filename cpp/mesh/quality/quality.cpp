#include "certet/quality.hpp"

#include <algorithm>
#include <cmath>

#include "extremes.hpp"

namespace certet {

WideSum& WideSum::operator+=(std::int64_t term) {
  return *this += WideSum{static_cast<std::uint64_t>(term), term < 0 ? -1 : 0};
}

WideSum& WideSum::operator+=(const WideSum& other) {
  low += other.low;
  high += other.high + (low < other.low ? 1 : 0);
  return *this;
}

WideSum WideSum::product(std::int64_t factor, std::uint64_t times) {
  WideSum sum, power{static_cast<std::uint64_t>(factor), factor < 0 ? -1 : 0};
  for (; times != 0; times >>= 1, power += WideSum(power))
    if ((times & 1) != 0) sum += power;
  return sum;
}

double WideSum::value() const {
  // The magnitude is converted, so that -1 does not cancel in huge terms.
  const bool negative = high < 0;
  const auto top = static_cast<std::uint64_t>(high);
  const std::uint64_t low_part = negative ? ~low + 1 : low;
  const std::uint64_t high_part = negative ? ~top + (low == 0 ? 1 : 0) : top;
  const double magnitude =
      std::ldexp(static_cast<double>(high_part), 64) + static_cast<double>(low_part);
  return negative ? -magnitude : magnitude;
}

Quality& Quality::operator+=(const Quality& other) {
  tets += other.tets;
  nonpositive += other.nonpositive;
  for (std::size_t i = 0; i < histogram.size(); ++i) histogram[i] += other.histogram[i];
  steps_volume += other.steps_volume;
  volume = steps_volume == WideSum{} ? volume + other.volume
                                     : core::long_edges_cubed(steps_volume);
  sharpest = std::max(sharpest, other.sharpest);
  bluntest = std::min(bluntest, other.bluntest);
  least_face = std::min(least_face, other.least_face);
  core::set_extremes(*this);
  return *this;
}

}  // namespace certet
