#pragma once
/// \file
/// Where the rest of winding numbers stays near one whole number.

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "box_tree.hpp"
#include "rims.hpp"

namespace certet {

/// How much of a winding number may be lost where rims are far away.
inline constexpr double lost_far_away = 0.02;

/// Away from rims, winding numbers are near whole ones.  In blocks of space that are far enough
/// from all of them, and from which no ray along x meets any, it is told once for all points
/// which one the rest is near to, so that it need not be summed up for each of them.
class SteadyRest {
 public:
  /// Nothing is known beyond a box, in steps.
  SteadyRest(const Rims& rims, const IntegerBox& box);

  /// The whole number that the rest of a position, however it was moved, is nearest to; by
  /// less than 1/2 - `lost_far_away`.  Nothing where that cannot be told.
  [[nodiscard]] std::optional<int> whole(Coord3 p) const;

  [[nodiscard]] std::uint64_t bytes() const;

 private:
  using Entry = std::atomic<std::int32_t>;

  [[nodiscard]] std::int32_t find(const std::int64_t (&block)[3]) const;

  const Rims& rims_;
  std::int64_t low_[3], count_[3];
  std::int64_t side_;  ///< of a block, in steps
  std::unique_ptr<Entry[]> blocks_;  ///< found when they are asked for
};

}  // namespace certet
