// The extension module `_certet`: the thin part of the Python package that needs
// C++.  What users see, and its documentation, is certet/__init__.py.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <utility>

#include "arrays.hpp"
#include "certet/bounds.hpp"
#include "certet/checksum.hpp"
#include "certet/error.hpp"
#include "certet/image.hpp"
#include "certet/placed_quality.hpp"
#include "certet/surface.hpp"
#include "domains.hpp"
#include "run.hpp"

namespace certet::python {
namespace {

/// A finished mesh; arrays handed out share its memory.
struct PythonMesh {
  Mesh mesh;
  Buffer<Point3> world;
  Buffer<std::int32_t> labels;  ///< empty where there are none
  Guarantee guarantee{};
  Cuts cuts{};
  std::uint64_t inverted_tets = 0;
  std::vector<std::string> notes;
};

struct Options {
  StuffingOptions stuffing;
  int threads = 0;
};

Guarantee guarantee_of(const std::string& wanted) {
  for (const Guarantee guarantee : {Guarantee::angles, Guarantee::embedding})
    if (wanted == name(guarantee)) return guarantee;
  return Guarantee::pieces;
}

Buffer<Point3> world_points(const Mesh& mesh) {
  Buffer<Point3> world(mesh.points.size());
  for (std::size_t i = 0; i < world.size(); ++i) world[i] = mesh.frame.world(mesh.points[i]);
  return world;
}

using Labels = std::function<void(std::span<const std::array<Coord3, 4>>, std::span<std::int32_t>)>;

Buffer<std::int32_t> labels_of(const Mesh& mesh, const Labels& label) {
  return std::visit(
      [&](const auto& tets) {
        Buffer<std::int32_t> labels(tets.size());
        for (std::size_t i = 0; i < tets.size(); ++i) {
          std::array<Coord3, 4> corners;
          for (std::size_t v = 0; v < 4; ++v)
            corners[v] = mesh.points[static_cast<std::size_t>(tets[i][v])];
          label({&corners, 1}, {&labels[i], 1});
        }
        return labels;
      },
      mesh.tets);
}

/// `place` makes the domain; it runs, like all the rest, without Python's lock.
struct Placed {
  std::shared_ptr<const Domain> domain;
  Lattice lattice;
  Frame frame;
  Labels label;  ///< empty where there are no labels
  std::vector<std::string> notes = {};  ///< what is doubtful about the solid
};

std::shared_ptr<PythonMesh> mesh_of(const std::function<Placed()>& place, const Options& options) {
  auto result = std::make_shared<PythonMesh>();
  Context context;
  context.threads = options.threads;
  run(context, [&] {
    const Placed placed = place();
    const Stuffing stuffing(*placed.domain, placed.lattice, options.stuffing, context);
    if (stuffing.tet_count() == 0)
      throw Error(ErrorCode::empty_domain, "nothing is inside at this size, so there is no mesh");
    result->mesh = emit(stuffing, placed.frame, context);
    result->guarantee = stuffing.guarantee();
    result->cuts = options.stuffing.cuts;
    result->inverted_tets = stuffing.inverted_tets();
    result->notes = placed.notes;
    result->world = world_points(result->mesh);
    if (placed.label) result->labels = labels_of(result->mesh, placed.label);
  });
  return result;
}

Placed placed(const std::shared_ptr<ImageDomain>& domain, bool labels) {
  Placed result{domain, domain->lattice(), domain->frame(), {}};
  if (labels)
    result.label = [domain](std::span<const std::array<Coord3, 4>> tets,
                            std::span<std::int32_t> out) { domain->label(tets, out); };
  return result;
}

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
        const ImageLattice lattice{size, margin};
        return iso ? placed(level_domain(std::move(image), *iso, lattice), false)
                   : placed(label_domain(std::move(image), ranges, lattice), true);
      },
      options);
}

std::shared_ptr<PythonMesh> mesh_function(py::object function, const Point3& low,
                                          const Point3& high, double size, int margin,
                                          const Options& options) {
  const BoxLattice box = lattice_around({low, high}, size, margin);
  // Kept here, under Python's lock, for it has to be let go of under it too.
  const PythonDomain domain(std::move(function), box.frame, {low, high});
  return mesh_of(
      [&] {
        return Placed{std::shared_ptr<const Domain>(std::shared_ptr<void>(), &domain), box.lattice,
                      box.frame, {}};
      },
      options);
}

std::shared_ptr<PythonMesh> mesh_surface(
    const py::array_t<double, py::array::c_style | py::array::forcecast>& points,
    const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>& triangles,
    double size, int margin, bool repair, const Options& options) {
  TriangleSurface surface;
  surface.name = "surface";
  const auto shape = [](const py::array& array, const char* what) {
    if (array.ndim() != 2 || array.shape(1) != 3)
      throw Error(ErrorCode::bad_input, std::string(what) + " are not of shape (n, 3)");
    return static_cast<std::size_t>(array.shape(0));
  };
  surface.points.resize(shape(points, "points"));
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    for (std::size_t a = 0; a < 3; ++a) surface.points[i][a] = points.data()[3 * i + a];
  surface.triangles.resize(shape(triangles, "triangles"));
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (std::size_t a = 0; a < 3; ++a) {
      const std::int64_t index = triangles.data()[3 * i + a];
      if (index < 0 || !std::in_range<std::uint32_t>(index))
        throw Error(ErrorCode::bad_input, "a triangle has the point number " +
                                              std::to_string(index) + ", which does not exist");
      surface.triangles[i][a] = static_cast<std::uint32_t>(index);
    }
  return mesh_of(
      [&] {
        const SurfaceRepairs repairs = repair_surface(surface, {repair});
        if (!is_closed(surface))
          refuse_open(surface, inspect(surface), repair ? "" : "repair=True closes what is open");
        std::shared_ptr<PlacedDomain> domain = surface_domain(surface, {size, margin});
        return Placed{domain, domain->lattice(), domain->frame(), {}, sentences_on(repairs)};
      },
      options);
}

py::dict quality_of(const PythonMesh& mesh) {
  const AngleBounds bounds = proven_bounds(mesh.cuts, mesh.guarantee);
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
  result["holds"] = judge(placed, bounds) == Standing::within;
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
  const auto& labels = self.cast<const PythonMesh&>().labels;
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
      .def(py::init([](bool midpoint, const std::string& guarantee, int threads) {
             return Options{{midpoint ? Cuts::midpoint : Cuts::bisect, guarantee_of(guarantee)},
                            threads};
           }),
           py::arg("midpoint"), py::arg("guarantee"), py::arg("threads"));
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
      .def_property_readonly("guarantee", [](const PythonMesh& mesh) {
        return name(mesh.guarantee);
      })
      .def_property_readonly("inverted_tets",
                             [](const PythonMesh& mesh) { return mesh.inverted_tets; })
      .def_property_readonly("notes", [](const PythonMesh& mesh) { return mesh.notes; })
      .def("checksum", checksum_of)
      .def("quality", quality_of);
  module.def("mesh_image", mesh_image);
  module.def("mesh_function", mesh_function);
  module.def("mesh_surface", mesh_surface);
  module.attr("version") = CERTET_VERSION;
}

}  // namespace certet::python
