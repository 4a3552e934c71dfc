#pragma once
/// \file
/// From meshes back to voxels.

#include <pybind11/pybind11.h>

namespace certet::python {

/// Declares voxelise.
void declare_voxelise(pybind11::module_& module);

}  // namespace certet::python
