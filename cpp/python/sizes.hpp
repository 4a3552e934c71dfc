#pragma once
/// \file
/// Sizes that vary from place to place, as Python gives them.

#include <pybind11/pybind11.h>

#include "certet/size_field.hpp"

namespace certet::python {

namespace py = pybind11;

/// `size_field_of_function`, `…_formula` and `…_image`, each of which makes a `SizeField`.
void declare_sizes(py::module_& module);

}  // namespace certet::python
