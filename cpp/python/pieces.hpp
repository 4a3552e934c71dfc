#pragma once
/// \file
/// The pieces of meshes.

#include <pybind11/pybind11.h>

namespace certet::python {

/// Declares pieces, of a Mesh and of a FileMesh.
void declare_pieces(pybind11::module_& module);

}  // namespace certet::python
