#pragma once
/// \file
/// Which labels are chosen.

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "certet/error.hpp"
#include "certet/image.hpp"

namespace certet {

/// A set of labels as disjoint ascending ranges.
class LabelSet {
 public:
  explicit LabelSet(std::vector<LabelRange> ranges) : ranges_(std::move(ranges)) {
    std::sort(ranges_.begin(), ranges_.end(),
              [](LabelRange a, LabelRange b) { return a.first < b.first; });
    std::vector<LabelRange> joined;
    for (const LabelRange range : ranges_) {
      if (!joined.empty() && range.first <= joined.back().last)
        joined.back().last = std::max(joined.back().last, range.last);
      else
        joined.push_back(range);
    }
    ranges_ = std::move(joined);
  }

  [[nodiscard]] bool contains(std::int64_t label) const {
    if (ranges_.empty()) return label != 0;
    const auto after = std::upper_bound(
        ranges_.begin(), ranges_.end(), label,
        [](std::int64_t value, LabelRange range) { return value < range.first; });
    return after != ranges_.begin() && label <= std::prev(after)->last;
  }

 private:
  std::vector<LabelRange> ranges_;  ///< empty: all but 0
};

/// \throws Error `bad_input`, for voxels that are no whole numbers.
[[noreturn]] inline void refuse_levels(const Image& image) {
  throw Error(ErrorCode::bad_input,
              "the voxels of '" + image.name +
                  "' are not whole numbers, so they are no labels; choose a level");
}

/// \throws Error `empty_domain`, where no voxel is chosen; `all`: of all labels but 0.
[[noreturn]] inline void refuse_unlabelled(const Image& image, bool all) {
  throw Error(ErrorCode::empty_domain,
              "no voxel of '" + image.name + "' has " +
                  (all ? "a label other than 0" : "one of the chosen labels"));
}

/// The cell field of labels has 32-bit signed numbers.
template <class T>
void refuse_wide_labels(const Image& image, const Buffer<T>& voxels, const LabelSet& set) {
  if constexpr (std::is_same_v<T, std::uint32_t>) {
    const auto wide = std::find_if(voxels.begin(), voxels.end(), [&](T label) {
      return label > std::uint32_t{std::numeric_limits<std::int32_t>::max()} &&
             set.contains(label);
    });
    if (wide != voxels.end())
      throw Error(ErrorCode::bad_input, "'" + image.name + "' has label " +
                                            std::to_string(*wide) +
                                            ", which does not fit 32 bits with a sign");
  }
}

}  // namespace certet
