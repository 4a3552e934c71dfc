#include "region_sums.hpp"

#include <algorithm>
#include <functional>
#include <tuple>

namespace certet::fields {

void RegionSums::add(const RegionSums& other) {
  std::ranges::transform(volumes_, other.volumes_, volumes_.begin(), std::plus<>());
  areas_.insert(areas_.end(), other.areas_.begin(), other.areas_.end());
}

void RegionSums::merge_areas() {
  const auto between = [](const Area& a) { return std::tuple(a.low, a.high); };
  std::ranges::sort(areas_, {}, between);
  std::vector<Area> merged;
  for (const Area& area : areas_) {
    if (merged.empty() || between(merged.back()) != between(area))
      merged.push_back(area);
    else
      merged.back().area += area.area;
  }
  areas_ = std::move(merged);
}

}  // namespace certet::fields
