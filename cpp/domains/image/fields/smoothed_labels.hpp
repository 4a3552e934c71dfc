#pragma once
/// \file
/// Smoothed indicators: of every label of a window, at the nodes of its tile.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fields/label_window.hpp"
#include "fields/taps.hpp"

namespace certet::fields {

/// In 16384ths.  Exact with taps of whole 16ths; other products are rounded down to a
/// 16384th along each axis.
class SmoothedLabels {
 public:
  static constexpr std::size_t row_length = 24;  ///< 17 nodes, and zeros

  void compute(const LabelWindow& window, const std::array<Taps, 3>& taps);

  /// Of the label number `rank` along x, or nullptr where all of it is 0.
  [[nodiscard]] const std::uint16_t* row(std::size_t rank, int y, int z) const {
    const Support& s = supports_[rank];
    if (y < s.low[0] || y > s.high[0] || z < s.low[1] || z > s.high[1]) return nullptr;
    return &values_[s.first + static_cast<std::size_t>((z - s.low[1]) * (s.high[0] - s.low[0] + 1) +
                                                       (y - s.low[0])) *
                                  row_length];
  }

 private:
  /// Along y and z, both ends included: first of voxels in the window, then of nodes
  /// that they reach.
  struct Support {
    std::array<int, 2> low, high;
    std::size_t first = 0;
  };

  void find_supports(const LabelWindow& window);
  /// Makes a support hold a row.
  void reach(std::size_t rank, int y, int z);
  void smooth(const LabelWindow& window, std::size_t rank, const std::array<Taps, 3>& taps);

  std::vector<Support> supports_;
  std::vector<std::uint16_t> values_, along_x_, along_y_;
  std::size_t used_ = 0;  ///< of the values
};

}  // namespace certet::fields
