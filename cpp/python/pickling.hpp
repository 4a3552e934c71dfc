#pragma once
/// \file
/// Meshes as what `pickle` and `copy` can take, and back.

#include <pybind11/pybind11.h>

#include <memory>

#include "certet/formats.hpp"
#include "python_mesh.hpp"

namespace certet::python {

/// Numbers go as bytes of this machine's order, which the state tells.
pybind11::tuple state_of(const PythonMesh& mesh);
pybind11::tuple state_of(const FileMesh& mesh);

/// \throws Error `bad_input` for the state of another version or machine.
std::shared_ptr<PythonMesh> mesh_of_state(const pybind11::tuple& state);
std::shared_ptr<FileMesh> file_mesh_of_state(const pybind11::tuple& state);

}  // namespace certet::python
