#include "interfaces.hpp"

#include <pybind11/stl.h>

#include <span>
#include <utility>
#include <vector>

#include "faces.hpp"
#include "python_mesh.hpp"

namespace certet::python {
namespace {

namespace py = pybind11;

/// For each a tuple of its labels, triangles and area; `made` finds them.
py::list told_of(Survey made, std::span<const Point3> points) {
  auto* const kept = new std::vector<Interface>(std::move(made.interfaces));
  const py::capsule owner(kept, [](void* memory) { delete static_cast<std::vector<Interface>*>(memory); });
  py::list all;
  for (const Interface& interface : *kept)
    all.append(py::make_tuple(py::make_tuple(interface.labels[0], interface.labels[1]),
                              points_of(interface.faces, owner), area_of(interface.faces, points)));
  return all;
}

}  // namespace

void declare_interfaces(py::module_& module) {
  module.def("interfaces", [](const PythonMesh& mesh) {
    return told_of(found_in(mesh.mesh), mesh.world);
  });
  module.def("interfaces", [](const FileMesh& mesh) {
    return told_of(found_in(mesh), mesh.points);
  });
}

}  // namespace certet::python
