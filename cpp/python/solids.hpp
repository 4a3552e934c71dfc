#pragma once
/// \file
/// Several solids as the materials of one mesh.

#include <pybind11/pybind11.h>

namespace certet::python {

void declare_solids(pybind11::module_& module);

}  // namespace certet::python
