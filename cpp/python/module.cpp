// The extension module `_certet`: the thin part of the Python package that needs
// C++.  What users see, and its documentation, is certet/__init__.py.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <utility>

#include "arrays.hpp"
#include "certet/checksum.hpp"
#include "certet/error.hpp"
#include "certet/image.hpp"
#include "certet/method.hpp"
#include "certet/placed_quality.hpp"
#include "certet/stuffing.hpp"
#include "certet/surface.hpp"
#include "domains.hpp"
#include "files.hpp"
#include "pieces.hpp"
#include "python_mesh.hpp"
#include "shapes.hpp"
#include "solids.hpp"

namespace certet::python {
namespace {

using Direction = std::array<std::array<double, 3>, 3>;

std::shared_ptr<PythonMesh> mesh_image(const py::array& array, const Point3& spacing,
                                       const Point3& origin, const Direction& direction,
                                       const std::vector<std::pair<std::int64_t, std::int64_t>>& labels,
                                       std::optional<double> iso, double size, int margin,
                                       const Options& options) {
  Image image;
  image.name = "array";
  image.spacing = spacing;
  image.origin = origin;
  image.axes = direction;
  image.voxels = voxels(array, image.size);
  std::vector<LabelRange> ranges;
  ranges.reserve(labels.size());
  for (const auto& [first, last] : labels) ranges.push_back({first, last});
  return mesh_of(
      [&] {
        const ImageLattice lattice{size, margin, !facts(options.method).settles};
        return Shape{iso ? level_domain(std::move(image), *iso, lattice)
                         : label_domain(std::move(image), ranges, lattice)};
      },
      options);
}

std::shared_ptr<PythonMesh> mesh_function(py::object function, const Point3& low,
                                          const Point3& high, double size, int margin,
                                          const Options& options) {
  const Bounds bounds{low, high};
  return mesh_of(
      [&, kept = kept(std::move(function))] {
        return Shape{std::make_shared<PythonDomain>(kept, bounds,
                                                    lattice_around(bounds, size, margin))};
      },
      options);
}

std::shared_ptr<PythonMesh> mesh_surface(const PointArray& points,
                                         const TriangleArray& triangles, double size, int margin,
                                         bool repair, const Options& options) {
  TriangleSurface surface = surface_of(points, triangles, "surface");
  return mesh_of(
      [&] {
        MendedSurface mended = mend(std::move(surface), repair);
        const SurfaceLattice lattice{size, margin};
        return Shape{mended.open ? open_surface_domain(mended.surface, lattice)
                                 : surface_domain(mended.surface, lattice),
                     std::move(mended.notes)};
      },
      options);
}

py::dict quality_of(const PythonMesh& mesh) {
  const AngleBounds bounds = bounds_of(mesh.mesh);
  PlacedQuality placed;
  {
    const py::gil_scoped_release unlocked;
    placed = measure_placed(mesh.mesh, mesh.world);
  }
  const auto& [lattice, world, rounding, coincident_points] = placed;
  py::dict result;
  result["tets"] = lattice.tets;
  result["volume"] = world.volume;
  result["min_dihedral"] = world.min_dihedral;
  result["max_dihedral"] = world.max_dihedral;
  result["histogram"] = lattice.histogram;
  result["theorem"] = std::string(bounds.theorem);
  result["proven_min"] = bounds.min_dihedral;
  result["proven_max"] = bounds.max_dihedral;
  result["holds"] = standing_of(placed, bounds) == Standing::within;
  return result;
}

std::uint64_t checksum_of(const PythonMesh& mesh) {
  const py::gil_scoped_release unlocked;
  Checksum checksum;
  checksum.points(0, mesh.mesh.points);
  std::visit(
      [&](const auto& tets) {
        using Index = std::remove_cvref_t<decltype(tets[0][0])>;
        checksum.tets(0, std::span<const Tet<Index>>(tets));
      },
      mesh.mesh.tets);
  return checksum.value();
}

py::object tets_of(const py::object& self) {
  const auto& mesh = self.cast<const PythonMesh&>();
  return std::visit(
      [&](const auto& tets) -> py::object {
        return rows(std::span(tets.data(), tets.size()), self);
      },
      mesh.mesh.tets);
}

py::object labels_of(const py::object& self) {
  const auto& labels = self.cast<const PythonMesh&>().mesh.labels;
  if (labels.empty()) return py::none();
  return py::array(py::dtype::of<std::int32_t>(),
                   {static_cast<py::ssize_t>(labels.size())},
                   {static_cast<py::ssize_t>(sizeof(std::int32_t))}, labels.data(), self);
}

py::array positions_of(const py::object& self) {
  static_assert(sizeof(Coord3) == 3 * sizeof(std::int32_t));
  const auto& points = self.cast<const PythonMesh&>().mesh.points;
  return py::array(py::dtype::of<std::int32_t>(), {static_cast<py::ssize_t>(points.size()), py::ssize_t{3}},
                   {static_cast<py::ssize_t>(sizeof(Coord3)), py::ssize_t{sizeof(std::int32_t)}}, &points.data()->x,
                   self);
}

/// What Python raises for an error of the library; pybind11 wants it to take a value.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
void translate(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const Error& error) {
    PyErr_SetString(error.code() == ErrorCode::too_large ? PyExc_MemoryError : PyExc_ValueError,
                    error.what());
  }
}

}  // namespace

PYBIND11_MODULE(_certet, module) {
  py::register_exception_translator(translate);
  py::class_<Options>(module, "Options")
      .def(py::init([](const std::string& method, int threads) {
             const std::optional<Method> named = method_named(method);
             if (!named)
               throw Error(ErrorCode::bad_option,
                           "method is one of " + method_names() + ", not '" + method + "'");
             return Options{*named, threads};
           }),
           py::arg("method"), py::arg("threads"));
  py::class_<PythonMesh, std::shared_ptr<PythonMesh>>(module, "Mesh")
      .def_property_readonly("points", [](const py::object& self) {
        const auto& world = self.cast<const PythonMesh&>().world;
        return rows(std::span(world.data(), world.size()), self);
      })
      .def_property_readonly("positions", positions_of)
      .def_property_readonly("tets", tets_of)
      .def_property_readonly("labels", py::overload_cast<const py::object&>(labels_of))
      .def_property_readonly("size", [](const PythonMesh& mesh) { return mesh.mesh.frame.size; })
      .def_property_readonly("origin", [](const PythonMesh& mesh) { return mesh.mesh.frame.origin; })
      .def_property_readonly("axes", [](const PythonMesh& mesh) { return mesh.mesh.frame.axes; })
      .def_property_readonly("method", [](const PythonMesh& mesh) {
        return std::string(name(mesh.mesh.method));
      })
      .def_property_readonly("names", [](const PythonMesh& mesh) { return mesh.mesh.names; })
      .def_property_readonly("notes", [](const PythonMesh& mesh) { return mesh.notes; })
      .def("checksum", checksum_of)
      .def("quality", quality_of);
  declare_files(module);
  declare_pieces(module);
  declare_solids(module);
  module.def("mesh_image", mesh_image);
  module.def("mesh_function", mesh_function);
  module.def("mesh_surface", mesh_surface);
  module.attr("version") = CERTET_VERSION;
}

}  // namespace certet::python
