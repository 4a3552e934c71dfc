#pragma once
/// \file
/// The patches of the boundary, as arrays, and names for them.

#include <pybind11/pybind11.h>

namespace certet::python {

/// Declares `patches` of meshes and of what files hold, and `name_patches` of meshes.
void declare_patches(pybind11::module_& module);

}  // namespace certet::python
