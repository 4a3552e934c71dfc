#pragma once
/// \file
/// Where regions touch, as arrays.

#include <pybind11/pybind11.h>

namespace certet::python {

/// Declares `interfaces` of meshes and of what files hold.
void declare_interfaces(pybind11::module_& module);

}  // namespace certet::python
