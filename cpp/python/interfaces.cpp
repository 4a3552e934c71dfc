#include "interfaces.hpp"

#include <pybind11/stl.h>

#include <span>
#include <utility>
#include <vector>

#include "faces.hpp"

namespace certet::python {
namespace {

namespace py = pybind11;

/// For each a tuple of its labels, triangles and area; `made` finds them.
py::list told_of(Survey made, std::span<const Point3> points) {
  const SharedFaces shared(std::move(made.interfaces));
  py::list all;
  for (const Interface& interface : *shared.kept)
    all.append(py::make_tuple(py::make_tuple(interface.labels[0], interface.labels[1]),
                              points_of(interface.faces, shared.owner), area_of(interface.faces, points)));
  return all;
}

}  // namespace

void declare_interfaces(py::module_& module) {
  declare_told(module, "interfaces", told_of);
}

}  // namespace certet::python
