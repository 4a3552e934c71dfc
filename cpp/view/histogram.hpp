#pragma once
/// \file
/// Histograms as SVG.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace certet::view {

/// A line across the histogram.
struct Mark {
  double at;
  bool certain;  ///< drawn strongly; otherwise lightly and without its number
};

struct Histogram {
  std::string id, title;  ///< title says what is counted
  std::span<const std::uint64_t> counts;
  double low, high;     ///< of all bins together, which have the same width
  std::string unit;     ///< behind numbers: "°", or nothing
  double tick;          ///< distance of the numbers on the axis; 0: low, middle, high
  std::vector<Mark> marks;
  bool open_end = false;  ///< the last bin takes all above
};

std::string svg(const Histogram& histogram);

}  // namespace certet::view
