#include "interfaces.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "certet/examine.hpp"
#include "certet/formats.hpp"
#include "certet/survey.hpp"
#include "python_mesh.hpp"
#include "run.hpp"

namespace certet::python {
namespace {

namespace py = pybind11;

/// The points of faces as an array of shape (n, 3) that shares their memory.
py::array points_of(const std::vector<BoundaryFace>& faces, const py::handle& owner) {
  constexpr auto item = static_cast<py::ssize_t>(sizeof(std::uint64_t));
  const std::uint64_t* const first = faces.empty() ? nullptr : faces.front().points.data();
  return {py::dtype::of<std::uint64_t>(), {static_cast<py::ssize_t>(faces.size()), py::ssize_t{3}},
          {static_cast<py::ssize_t>(sizeof(BoundaryFace)), item}, first, owner};
}

double area_of(const std::vector<BoundaryFace>& faces, std::span<const Point3> points) {
  double area = 0;
  for (const BoundaryFace& face : faces) {
    const auto [a, b, c] = face.points;
    area += certet::area_of(points[a], points[b], points[c]);
  }
  return area;
}

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

template <class AnyMesh>
Survey found_in(const AnyMesh& mesh) {
  Context context;
  Survey found;
  run(context, [&] { found = survey(mesh, context); });
  return found;
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
