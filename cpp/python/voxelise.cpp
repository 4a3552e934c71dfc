#include "voxelise.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "arrays.hpp"
#include "certet/formats.hpp"
#include "certet/voxelise.hpp"
#include "python_mesh.hpp"
#include "run.hpp"

namespace certet::python {
namespace {

using Direction = std::array<std::array<double, 3>, 3>;

/// Labels whose first index runs fastest, in memory that is the array's own.
py::array array_of(Image image) {
  auto labels = std::make_unique<Buffer<std::int32_t>>(
      std::move(std::get<Buffer<std::int32_t>>(image.voxels)));
  const std::int32_t* const data = labels->data();
  const py::capsule owner(labels.release(), [](void* owned) {
    delete static_cast<Buffer<std::int32_t>*>(owned);
  });
  constexpr py::ssize_t item = sizeof(std::int32_t);
  const auto& [nx, ny, nz] = image.size;
  return py::array(py::dtype::of<std::int32_t>(), {nx, ny, nz}, {item, item * nx, item * nx * ny},
                   data, owner);
}

/// \returns the labels, and what is doubtful about them.
template <class AnyMesh>
std::pair<py::array, std::vector<std::string>> voxelise_mesh(
    const AnyMesh& mesh, const std::array<std::int64_t, 3>& size, const Point3& spacing,
    const Point3& origin, const Direction& direction) {
  Image grid;
  grid.name = "the grid";
  grid.size = size;
  grid.spacing = spacing;
  grid.origin = origin;
  grid.axes = direction;
  VoxelisedMesh made;
  Context context;
  run(context, [&] { made = voxelise(mesh, std::move(grid), context); });
  std::vector<std::string> warnings = warnings_on_voxels(made);
  return {array_of(std::move(made.image)), std::move(warnings)};
}

}  // namespace

void declare_voxelise(py::module_& module) {
  module.def("voxelise", voxelise_mesh<FileMesh>);
  module.def("voxelise", [](const PythonMesh& mesh, const std::array<std::int64_t, 3>& size,
                            const Point3& spacing, const Point3& origin,
                            const Direction& direction) {
    return voxelise_mesh(mesh.mesh, size, spacing, origin, direction);
  });
}

}  // namespace certet::python
