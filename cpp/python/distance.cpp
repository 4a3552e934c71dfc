#include "distance.hpp"

#include <pybind11/stl.h>

#include <span>

#include "certet/distance.hpp"
#include "certet/formats.hpp"
#include "certet/survey.hpp"
#include "python_mesh.hpp"
#include "python_solid.hpp"
#include "run.hpp"

namespace certet::python {
namespace {

namespace py = pybind11;

py::tuple told(const Distance& one) {
  return py::make_tuple(one.greatest, one.rms, one.at, one.points);
}

template <class AnyMesh>
py::tuple distance(const AnyMesh& mesh, std::span<const Point3> points, const PythonSolid& shape,
                   double edge, int threads) {
  Context context;
  context.threads = threads;
  DistanceFigures found;
  run(context, [&] {
    found = measure_distance(points, survey(mesh, context), shape.solid, edge, context);
  });
  return py::make_tuple(told(found.to_shape), told(found.to_mesh), found.edge, found.exact);
}

}  // namespace

void declare_distance(py::module_& module) {
  module.def("distance", [](const PythonMesh& mesh, const PythonSolid& shape, int threads) {
    return distance(mesh.mesh, {mesh.world.data(), mesh.world.size()}, shape, mesh.mesh.frame.size, threads);
  });
  module.def("distance", [](const FileMesh& mesh, const PythonSolid& shape, int threads) {
    return distance(mesh, mesh.points, shape, 0, threads);
  });
}

}  // namespace certet::python
