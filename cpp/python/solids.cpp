#include "solids.hpp"

#include <pybind11/stl.h>

#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "certet/materials_domain.hpp"
#include "domains.hpp"
#include "shapes.hpp"

namespace certet::python {
namespace {

/// A solid as Python gives it: of a function and its bounds, or of triangles.
struct PythonSolid {
  std::string name;
  KeptFunction function;  ///< none: of triangles
  Bounds bounds;
  TriangleSurface surface;
};

PythonSolid solid_of_function(std::string name, py::object function, const Point3& low,
                              const Point3& high) {
  return {std::move(name), kept(std::move(function)), {low, high}, {}};
}

PythonSolid solid_of_surface(const std::string& name, const PointArray& points,
                             const TriangleArray& triangles) {
  return {name, nullptr, {}, surface_of(points, triangles, name)};
}

/// What was done to a surface goes to `notes`.
Solid solid_of(const PythonSolid& given, bool repair, std::vector<std::string>& notes) {
  if (given.function)
    return {given.bounds,
            [function = given.function, bounds = given.bounds](const PlacedLattice& around) {
              return std::make_shared<PythonDomain>(function, bounds, around);
            }};
  MendedSurface mended = mend(given.surface, repair);
  std::ranges::move(mended.notes, std::back_inserter(notes));
  auto surface = std::make_shared<const TriangleSurface>(std::move(mended.surface));
  return mended.open ? open_surface_solid(std::move(surface)) : surface_solid(std::move(surface));
}

std::shared_ptr<PythonMesh> mesh_solids(const std::vector<PythonSolid>& given,
                                        const std::vector<std::string>& priority, double size,
                                        int margin, bool repair, const Options& options) {
  return mesh_of(
      [&](const Context&) {
        Shape shape;
        const auto solids = std::make_shared<std::vector<NamedSolid>>();
        for (const PythonSolid& one : given) {
          solids->push_back({one.name, solid_of(one, repair, shape.notes)});
          shape.sized.name += (shape.sized.name.empty() ? "" : ", ") + one.name;
          if (one.function) shape.sized.cost = cost_of_python;
        }
        shape.sized.place = [=](double at) {
          return materials_domain(*solids, {at, margin}, priority);
        };
        shape.sized.pieces = unknown_pieces;
        return shape;
      },
      size, options);
}

}  // namespace

void declare_solids(py::module_& module) {
  py::class_<PythonSolid>(module, "Solid");
  module.def("solid_of_function", solid_of_function);
  module.def("solid_of_surface", solid_of_surface);
  module.def("mesh_solids", mesh_solids);
}

}  // namespace certet::python
