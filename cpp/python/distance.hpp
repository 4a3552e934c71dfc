#pragma once
/// \file
/// How far meshes are from solids.

#include <pybind11/pybind11.h>

namespace certet::python {

void declare_distance(pybind11::module_& module);

}  // namespace certet::python
