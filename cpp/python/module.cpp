// The extension module `_certet`: the thin part of the Python package that needs
// C++.  What users see, and its documentation, is certet/__init__.py.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <functional>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "arrays.hpp"
#include "certet/checksum.hpp"
#include "certet/error.hpp"
#include "certet/image.hpp"
#include "certet/label_warnings.hpp"
#include "certet/method.hpp"
#include "certet/placed_quality.hpp"
#include "certet/surface.hpp"
#include "distance.hpp"
#include "domains.hpp"
#include "files.hpp"
#include "images.hpp"
#include "interfaces.hpp"
#include "patches.hpp"
#include "pickling.hpp"
#include "pieces.hpp"
#include "python_mesh.hpp"
#include "shapes.hpp"
#include "sizes.hpp"
#include "solids.hpp"
#include "voxelise.hpp"

namespace certet::python {
namespace {

using namespace py::literals;

/// The voxels of an image as a shape; by default surfaces of labels are smooth where the
/// method cuts labels apart.
std::unique_ptr<PlacedDomain> image_domain(const std::shared_ptr<const Image>& image,
                                           const std::vector<LabelRange>& labels,
                                           std::optional<double> iso,
                                           std::optional<double> smooth,
                                           const ImageLattice& lattice, Method method,
                                           const Context& context) {
  if (iso) return level_domain(image, *iso, lattice);
  if (!facts(method).interfaces && smooth.value_or(0) != 0)
    throw Error(ErrorCode::bad_option, "smooth goes with the methods that cut labels apart");
  if (smooth == 0.0 || !facts(method).interfaces) return label_domain(image, labels, lattice);
  return interface_domain(image, labels, lattice, {smooth}, context);
}

std::shared_ptr<PythonMesh> mesh_image(const py::array& array, const Point3& spacing,
                                       const Point3& origin, const Direction& direction,
                                       const std::vector<std::pair<std::int64_t, std::int64_t>>& labels,
                                       const Levels& iso,
                                       std::optional<double> smooth, const Merges& merges,
                                       const std::optional<std::pair<Point3, Point3>>& crop,
                                       double size, int margin, const Options& options) {
  Image image = image_of(array, spacing, origin, direction);
  const std::vector<LabelRange> ranges = ranges_of(labels);
  return mesh_of(
      [&](const Context& context) {
        const std::optional<double> level = prepare(image, iso, merges);
        const auto kept = std::make_shared<const Image>(std::move(image));
        const auto place = [=, &context](double at) {
          const ImageLattice lattice{at, margin, !facts(options.method).settles};
          auto whole = image_domain(kept, ranges, level, smooth, lattice, options.method, context);
          return crop ? cropped_domain(std::move(whole), {crop->first, crop->second})
                      : std::move(whole);
        };
        Shape shape{{kept->name, place}};
        if (crop) return shape;
        if (level) {
          shape.sized.pieces = [=](Context& own) { return pieces_above(*kept, *level, own); };
          return shape;
        }
        shape.sized.volume = volume_of_labels(*kept, ranges);
        shape.warnings = [=](const Mesh& mesh) {
          return warnings_on_labels(*kept, ranges, mesh, {"size=", "iso=V"});
        };
        return shape;
      },
      size, options);
}

std::shared_ptr<PythonMesh> mesh_function(const py::object& function, const Point3& low,
                                          const Point3& high, std::size_t batch, double size,
                                          int margin, const Options& options) {
  const Bounds bounds{low, high};
  return mesh_of(
      [&, kept = kept(function)](const Context&) {
        const auto place = [=](double at) {
          return std::make_unique<PythonDomain>(kept, bounds, batch,
                                                lattice_around(bounds, at, margin));
        };
        Shape shape{{"function", place}};
        shape.sized.cost = cost_of_python;
        shape.sized.pieces = unknown_pieces;
        return shape;
      },
      size, options);
}

std::shared_ptr<PythonMesh> mesh_surface(const PointArray& points,
                                         const TriangleArray& triangles, double size, int margin,
                                         bool repair, const Options& options) {
  TriangleSurface surface = surface_of(points, triangles, "surface");
  return mesh_of(
      [&](const Context&) {
        const auto mended = std::make_shared<const MendedSurface>(mend(std::move(surface), repair));
        const auto place = [mended, margin](double at) {
          const SurfaceLattice lattice{at, margin};
          return mended->open ? open_surface_domain(mended->surface, lattice)
                              : surface_domain(mended->surface, lattice);
        };
        const SurfaceMeasures measures = measure(mended->surface);
        Shape shape{{mended->surface.name, place}, mended->notes};
        if (!mended->open) shape.sized.volume = measures.volume;
        shape.sized.thin = measures.thin;
        shape.sized.pieces = [mended](Context& context) {
          return pieces_of(mended->surface, inspect(mended->surface, context), context);
        };
        return shape;
      },
      size, options);
}

py::dict quality_of(const PythonMesh& mesh) {
  const AngleBounds bounds = bounds_of(mesh.mesh);
  PlacedQuality placed;
  {
    const py::gil_scoped_release unlocked;
    placed = measure_placed(mesh.mesh, mesh.world);
  }
  const auto& [lattice, world, rounding, coincident_points] = placed;
  return py::dict("tets"_a = lattice.tets, "volume"_a = world.volume,
                  "min_dihedral"_a = world.min_dihedral, "max_dihedral"_a = world.max_dihedral,
                  "histogram"_a = lattice.histogram, "theorem"_a = std::string(bounds.theorem),
                  "proven_min"_a = bounds.min_dihedral, "proven_max"_a = bounds.max_dihedral,
                  "holds"_a = standing_of(placed, bounds) == Standing::within);
}

py::dict warp_of(const PythonMesh& mesh) {
  const ShiftLengths edges = shift_in_edges(mesh.warp);
  const ShiftLengths world = shift_in_world(mesh.warp, mesh.mesh.frame.size);
  const ShiftLengths missed = missed_by(mesh.warp, 1);
  return py::dict("violated"_a = mesh.warp.violated, "stayed"_a = mesh.warp.stayed,
                  "shortened"_a = mesh.warp.shortened, "clamped_cuts"_a = world.cuts,
                  "greatest"_a = world.greatest, "rms"_a = world.rms,
                  "greatest_edges"_a = edges.greatest, "rms_edges"_a = edges.rms,
                  "missed_edges"_a = missed.greatest, "missed_rms_edges"_a = missed.rms);
}

std::uint64_t checksum_of(const PythonMesh& mesh) {
  const py::gil_scoped_release unlocked;
  return checksum(mesh.mesh);
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

/// None of tetrahedra of four nodes; so the next.
py::object middle_points_of(const py::object& self) {
  const auto& middles = self.cast<const PythonMesh&>().middles;
  if (!middles) return py::none();
  return rows(std::span(middles->points.data(), middles->points.size()), self);
}

py::object middles_of(const py::object& self) {
  const auto& middles = self.cast<const PythonMesh&>().middles;
  if (!middles) return py::none();
  return rows(std::span(middles->of_tets.data(), middles->of_tets.size()), self);
}

/// None where no middle node was put on the surface.
py::object curve_of(const PythonMesh& mesh) {
  if (!mesh.middles || !mesh.middles->curved) return py::none();
  const CurveFigures& figures = *mesh.middles->curved;
  return py::dict("edges"_a = figures.edges, "moved"_a = figures.moved,
                  "on_surface"_a = figures.on_surface, "guarded"_a = figures.guarded,
                  "far"_a = figures.far, "seams"_a = figures.seams,
                  "greatest_edges"_a = figures.greatest_move,
                  "least_jacobian"_a = figures.least_jacobian);
}

/// None where vertices stayed where they were.
py::object optimised_of(const PythonMesh& mesh) {
  if (!mesh.optimised) return py::none();
  const OptimiseFigures& figures = *mesh.optimised;
  return py::dict("goal"_a = figures.goal, "rounds"_a = figures.rounds, "moved"_a = figures.moved,
                  "moved_on_surface"_a = figures.moved_on_surface,
                  "moved_on_seams"_a = figures.moved_on_seams,
                  "left_surface"_a = figures.left_surface,
                  "greatest_edges"_a = figures.greatest_move,
                  "greatest_on_surface_edges"_a = figures.greatest_move_on_surface,
                  "short_before"_a = figures.short_before, "short_after"_a = figures.short_after);
}

/// Whether vertices moved onto sharp edges, why, and what became of it.
py::dict features_told(const PythonMesh& mesh) {
  const auto& [angle, creases, why] = mesh.features;
  const FeatureFigures figures = mesh.kept.value_or(FeatureFigures{});
  return py::dict("angle"_a = angle, "why"_a = why,
                  "length"_a = figures.length * mesh.mesh.frame.size,
                  "followed_percent"_a = figures.followed_percent(),
                  "kept_percent"_a = figures.kept_percent(), "corners"_a = figures.corners,
                  "kept_corners"_a = figures.kept_corners,
                  "greatest_distance_edges"_a = figures.greatest_distance,
                  "moved"_a = figures.moved, "greatest_move_edges"_a = figures.greatest_move);
}

py::array positions_of(const py::object& self) {
  static_assert(sizeof(Coord3) == 3 * sizeof(std::int32_t));
  const auto& points = self.cast<const PythonMesh&>().mesh.points;
  return py::array(py::dtype::of<std::int32_t>(), {static_cast<py::ssize_t>(points.size()), py::ssize_t{3}},
                   {static_cast<py::ssize_t>(sizeof(Coord3)), py::ssize_t{sizeof(std::int32_t)}}, &points.data()->x,
                   self);
}

/// None where all pieces were to stay.
py::object dropped_of(const PythonMesh& mesh) {
  if (!mesh.dropped) return py::none();
  return py::dict("pieces"_a = mesh.dropped->pieces, "tets"_a = mesh.dropped->tets,
                  "volume"_a = mesh.dropped->volume);
}

std::optional<KeepRule> rule_of(const std::optional<std::string>& text) {
  if (!text) return std::nullopt;
  const std::optional<KeepRule> rule = keep_rule(*text);
  if (!rule)
    throw Error(ErrorCode::bad_option,
                "keep is 'largest', a number of pieces, or 'percolating:x', y or z, not '" + *text +
                    "'");
  return rule;
}

/// What is told how far a run is: a function of Python, or None.
Follow follower(const py::object& function) {
  if (function.is_none()) return {};
  return [function](Stage stage, std::int64_t done, std::int64_t total) {
    function(std::string(name(stage)), done, total);
  };
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
  declare_sizes(module);
  py::class_<Options>(module, "Options")
      .def(py::init([](const std::string& method, int threads, int order, bool curved,
                       double optimise, bool automatic, std::optional<double> features,
                       std::int32_t grade, std::optional<SizeField> sizes,
                       const std::optional<std::string>& keep, std::uint64_t target_tets,
                       const py::object& progress) {
             const std::optional<Method> named = method_named(method);
             if (!named)
               throw Error(ErrorCode::bad_option,
                           "method is one of " + method_names() + ", not '" + method + "'");
             return Options{*named,   threads,
                            order,    curved,
                            optimise, {automatic, features},
                            grade,    std::move(sizes),
                            rule_of(keep), target_tets, follower(progress)};
           }),
           py::arg("method"), py::arg("threads"), py::arg("order"), py::arg("curved"),
           py::arg("optimise"), py::arg("automatic"), py::arg("features"), py::arg("grade"),
           py::arg("sizes"), py::arg("keep"), py::arg("target_tets"), py::arg("progress"));
  py::class_<PythonMesh, std::shared_ptr<PythonMesh>>(module, "Mesh")
      .def_property_readonly("points", [](const py::object& self) {
        const auto& world = self.cast<const PythonMesh&>().world;
        return rows(std::span(world.data(), world.size()), self);
      })
      .def_property_readonly("positions", positions_of)
      .def_property_readonly("tets", tets_of)
      .def_property_readonly("labels", py::overload_cast<const py::object&>(labels_of))
      .def_property_readonly("middle_points", middle_points_of)
      .def_property_readonly("middles", middles_of)
      .def_property_readonly("curve", curve_of)
      .def_property_readonly("optimised", optimised_of)
      .def_property_readonly("features", features_told)
      .def_property_readonly("dropped", dropped_of)
      .def_property_readonly("size", [](const PythonMesh& mesh) { return mesh.mesh.frame.size; })
      .def_property_readonly("origin", [](const PythonMesh& mesh) { return mesh.mesh.frame.origin; })
      .def_property_readonly("axes", [](const PythonMesh& mesh) { return mesh.mesh.frame.axes; })
      .def_property_readonly("method", [](const PythonMesh& mesh) {
        return std::string(name(mesh.mesh.method));
      })
      .def_property_readonly("warp", warp_of)
      .def_property_readonly("losses", [](const PythonMesh& mesh) { return mesh.losses; })
      .def_property_readonly("names", [](const PythonMesh& mesh) { return mesh.mesh.names; })
      .def_property_readonly("warnings", [](const PythonMesh& mesh) { return mesh.warnings; })
      .def_property_readonly("notes", [](const PythonMesh& mesh) { return mesh.notes; })
      .def(py::pickle([](const PythonMesh& mesh) { return state_of(mesh); },
                      [](const py::tuple& state) { return mesh_of_state(state); }))
      .def("checksum", checksum_of)
      .def("quality", quality_of);
  declare_files(module);
  declare_interfaces(module);
  declare_patches(module);
  declare_pieces(module);
  declare_solids(module);
  declare_distance(module);
  declare_voxelise(module);
  module.def("mesh_image", mesh_image);
  module.def("mesh_function", mesh_function);
  module.def("mesh_surface", mesh_surface);
  module.attr("version") = CERTET_VERSION;
}

}  // namespace certet::python
