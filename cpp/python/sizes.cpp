#include "sizes.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "certet/error.hpp"
#include "certet/size_fields.hpp"
#include "domains.hpp"
#include "images.hpp"

namespace certet::python {
namespace {

void ask(const py::object& function, std::span<const Point3> points, std::span<double> sizes) {
  const py::gil_scoped_acquire locked;
  const auto count = static_cast<py::ssize_t>(points.size());
  py::array_t<double> places({count, py::ssize_t{3}});
  double* to = places.mutable_data();
  for (const Point3& point : points) to = std::ranges::copy(point, to).out;
  const py::array_t<double, py::array::c_style | py::array::forcecast> values = function(places);
  if (values.size() != count)
    throw Error(ErrorCode::bad_input, "the size field gave " + std::to_string(values.size()) +
                                          " numbers for " + std::to_string(count) + " points");
  std::copy_n(values.data(), sizes.size(), sizes.begin());
}

/// Called with arrays of shape (n, 3), by one thread at a time.
SizeField of_function(py::object function) {
  return {"function", [function = kept(std::move(function))](std::span<const Point3> points,
                                                              std::span<double> sizes) {
            ask(*function, points, sizes);
          }};
}

SizeField of_image(const py::array& array, const Point3& spacing, const Point3& origin,
                   const Direction& direction) {
  return image_sizes(image_of(array, spacing, origin, direction));
}

}  // namespace

void declare_sizes(py::module_& module) {
  py::class_<SizeField>(module, "SizeField");
  module.def("size_field_of_function", of_function);
  module.def("size_field_of_formula", formula_sizes);
  module.def("size_field_of_image", of_image);
}

}  // namespace certet::python
