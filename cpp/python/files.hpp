#pragma once
/// \file
/// Meshes to and from files, and their check.

#include <pybind11/pybind11.h>

namespace certet::python {

/// Declares FileMesh, read, write and check.
void declare_files(pybind11::module_& module);

}  // namespace certet::python
