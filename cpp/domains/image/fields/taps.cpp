#include "taps.hpp"

#include <cmath>
#include <cstddef>

namespace certet::fields {

double Taps::variance() const {
  double sum = 0;
  for (std::size_t t = 0; t < weights.size(); ++t) {
    const double away = static_cast<double>(t) - radius();
    sum += away * away * weights[t];
  }
  return sum / 65536;
}

Taps binomial_taps() { return {{1 << 12, 4 << 12, 6 << 12, 4 << 12, 1 << 12}}; }

Taps thin_taps() { return {{3 << 12, 10 << 12, 3 << 12}}; }

Taps gaussian_taps(double sigma) {
  const int radius = static_cast<int>(std::ceil(2.5 * sigma));
  std::vector<double> half;  // from the middle outwards
  double sum = 0;
  for (int t = 0; t <= radius; ++t) {
    half.push_back(std::exp(-0.5 * t * t / (sigma * sigma)));
    sum += (t == 0 ? 1 : 2) * half.back();
  }
  std::vector<int> rounded;
  int middle = 4096;
  for (int t = 1; t <= radius; ++t) {
    const double share = half[static_cast<std::size_t>(t)] / sum;
    const int weight = static_cast<int>(std::lround(4096 * share));
    if (weight == 0) break;
    rounded.push_back(weight);
    middle -= 2 * weight;
  }
  if (rounded.empty()) return {};
  Taps taps;
  for (auto weight = rounded.rbegin(); weight != rounded.rend(); ++weight)
    taps.weights.push_back(static_cast<std::uint16_t>(16 * *weight));
  taps.weights.push_back(static_cast<std::uint16_t>(16 * middle));
  for (const int weight : rounded) taps.weights.push_back(static_cast<std::uint16_t>(16 * weight));
  return taps;
}

Taps narrower(const Taps& one, const Taps& other) {
  return other.variance() < one.variance() ? other : one;
}

}  // namespace certet::fields
