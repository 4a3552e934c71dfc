#include "angle_bins.hpp"

#include <cmath>
#include <numbers>

namespace certet::core {
namespace {

/// cos |cos| of the lower end of a bin, 0 <= bin <= Quality::bins.
double edge_of(int bin) {
  constexpr int degrees_per_bin = 180 / Quality::bins;
  const int degrees = bin * degrees_per_bin;
  if (degrees > 90) return -edge_of(Quality::bins - bin);
  if (degrees == 30) return 0.75;
  if (degrees == 45) return 0.5;
  if (degrees == 60) return 0.25;
  if (degrees == 90) return 0;
  const double cosine = std::cos(degrees * (std::numbers::pi / 180));
  return cosine * cosine;
}

}  // namespace

AngleBins::AngleBins() {
  int bin = Quality::bins - 1;
  for (std::int32_t i = 0; i <= cells; ++i) {
    // The bin of the greatest value in the cell, as edges fall with the bins.
    const double top = (i + 1) * (2.0 / cells) - 1;
    while (bin > 0 && edge_of(bin) < top) --bin;
    // 180 degrees belong to the last bin: below its edge lies nothing.
    const double below = -2;
    cells_[static_cast<std::size_t>(i)] = {
        bin + 1 < Quality::bins ? edge_of(bin + 1) : below, static_cast<std::size_t>(bin)};
  }
}

const AngleBins& angle_bins() {
  static const AngleBins bins;
  return bins;
}

}  // namespace certet::core
