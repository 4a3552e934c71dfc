#pragma once
/// \file
/// The voxels of all lattice coordinates along one axis, looked up once.

#include <cstddef>
#include <vector>

#include "placement.hpp"

namespace certet {

/// `entry(lattice coordinate)` for the coordinates that a lattice uses.
template <class Entry>
class AxisTable {
 public:
  template <class Make>
  AxisTable(std::int32_t origin, std::int32_t cells, const Make& make) : origin_(origin) {
    entries_.reserve(2 * static_cast<std::size_t>(cells));
    for (std::int32_t i = 0; i < 2 * cells; ++i)
      entries_.push_back(make(static_cast<double>(origin + i)));
  }

  [[nodiscard]] bool holds(std::int32_t first, std::size_t stride_two_count) const {
    const std::int64_t from = std::int64_t{first} - origin_;
    const auto span = static_cast<std::int64_t>(2 * stride_two_count) - 1;
    return from >= 0 && from + span <= static_cast<std::int64_t>(entries_.size());
  }
  /// The entry of `first`; that of `first + 2` stands two behind it.
  [[nodiscard]] const Entry* from(std::int32_t first) const {
    return entries_.data() + (first - origin_);
  }

 private:
  std::int32_t origin_;
  std::vector<Entry> entries_;
};

}  // namespace certet
