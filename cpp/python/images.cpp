#include "images.hpp"

#include <pybind11/stl.h>

#include <cmath>

#include "arrays.hpp"
#include "certet/gray_levels.hpp"

namespace certet::python {

Image image_of(const py::array& array, const Point3& spacing, const Point3& origin,
               const Direction& direction) {
  Image image;
  image.name = "array";
  image.spacing = spacing;
  image.origin = origin;
  image.axes = direction;
  image.voxels = voxels(array, image.size);
  return image;
}

std::vector<LabelRange> ranges_of(
    const std::vector<std::pair<std::int64_t, std::int64_t>>& labels) {
  std::vector<LabelRange> ranges;
  ranges.reserve(labels.size());
  for (const auto& [first, last] : labels) ranges.push_back({first, last});
  return ranges;
}

std::optional<double> prepare(Image& image, const Levels& iso, const Merges& merges) {
  std::optional<double> level;
  if (iso) level = std::isfinite(iso->second) ? 0 : iso->first;
  if (level && std::isfinite(iso->second))
    image = between_levels(image, {iso->first, iso->second});
  std::vector<LabelMerge> wanted;
  for (const auto& [first, last, to, name] : merges) wanted.push_back({{first, last}, to, name});
  if (!wanted.empty()) merge_labels(image, std::move(wanted));
  return level;
}

}  // namespace certet::python
