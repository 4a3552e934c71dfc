#include "certet/gray_levels.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "certet/error.hpp"
#include "geometry.hpp"

namespace certet {
namespace {

/// Single precision holds the difference where it holds the value: its sign is right.
template <class T>
using Distance = std::conditional_t<(sizeof(T) > 2 && !std::is_same_v<T, float>), double, float>;

template <class T>
Voxels distances(const Buffer<T>& voxels, const GrayLevels& levels) {
  Buffer<Distance<T>> result(voxels.size());
  std::ranges::transform(voxels, result.begin(), [&](T voxel) {
    const auto value = static_cast<double>(voxel);
    // NaN stays NaN, which is refused by what meshes the image.
    const double within = std::isnan(value) ? value : std::min(value - levels.above, levels.below - value);
    return static_cast<Distance<T>>(within);
  });
  return result;
}

}  // namespace

Image between_levels(const Image& image, const GrayLevels& levels) {
  if (!(levels.above < levels.below))
    throw Error(ErrorCode::bad_option, "of two levels the first must be less than the second");
  if (!std::isfinite(levels.above) && !std::isfinite(levels.below))
    throw Error(ErrorCode::bad_option, "of two levels one at least must be finite");
  Image result = place_of(image);
  result.notes = image.notes;
  result.voxels = std::visit([&](const auto& voxels) { return distances(voxels, levels); }, image.voxels);
  return result;
}

}  // namespace certet
