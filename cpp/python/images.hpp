#pragma once
/// \file
/// Images as Python gives them.

#include <pybind11/numpy.h>

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "certet/image.hpp"
#include "certet/merge_labels.hpp"

namespace certet::python {

namespace py = pybind11;

using Direction = std::array<std::array<double, 3>, 3>;
/// First and last label, the label that they become, and its name.
using Merges = std::vector<std::tuple<std::int64_t, std::int64_t, std::int32_t, std::string>>;
/// What a solid's values are above and below.
using Levels = std::optional<std::pair<double, double>>;

/// An array's voxels where they lie.  To be called with Python's lock.
Image image_of(const py::array& array, const Point3& spacing, const Point3& origin,
               const Direction& direction);

std::vector<LabelRange> ranges_of(const std::vector<std::pair<std::int64_t, std::int64_t>>& labels);

/// Makes of an image what is to be meshed: labels merged, or one level.  \returns the level.
std::optional<double> prepare(Image& image, const Levels& iso, const Merges& merges);

}  // namespace certet::python
