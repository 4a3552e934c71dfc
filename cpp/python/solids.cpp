#include "solids.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "certet/combined_solids.hpp"
#include "certet/error.hpp"
#include "certet/formula.hpp"
#include "certet/image_solids.hpp"
#include "certet/materials_domain.hpp"
#include "certet/shape.hpp"
#include "domains.hpp"
#include "images.hpp"
#include "python_solid.hpp"
#include "run.hpp"
#include "shapes.hpp"

namespace certet::python {
namespace {

/// `make` runs without Python's lock, and Ctrl-C stops it.
template <class Make>
PythonSolid made(const Make& make) {
  PythonSolid result;
  Context context;
  run(context, [&] { result = make(context); });
  return result;
}

PythonSolid solid_of_function(py::object function, const Point3& low, const Point3& high,
                              std::size_t batch) {
  const Bounds bounds{low, high};
  return {{bounds,
           [function = kept(std::move(function)), bounds, batch](const PlacedLattice& around) {
             return std::make_shared<PythonDomain>(function, bounds, batch, around);
           }},
          {},
          cost_of_python};
}

PythonSolid solid_of_surface(std::string name, const PointArray& points,
                             const TriangleArray& triangles, bool repair) {
  TriangleSurface given = surface_of(points, triangles, std::move(name));
  return made([&](const Context&) -> PythonSolid {
    MendedSurface mended = mend(std::move(given), repair);
    auto surface = std::make_shared<const TriangleSurface>(std::move(mended.surface));
    return {mended.open ? open_surface_solid(std::move(surface))
                        : surface_solid(std::move(surface)),
            std::move(mended.notes)};
  });
}

PythonSolid solid_of_text(const std::string& text, const std::optional<Bounds>& bounds) {
  if (is_shape(text)) return {shape_solid(text, bounds)};
  if (!bounds) throw Error(ErrorCode::bad_option, "a formula needs bounds");
  return {formula_solid(text, *bounds)};
}

PythonSolid solid_of_image(const py::array& array, const Point3& spacing, const Point3& origin,
                           const Direction& direction,
                           const std::vector<std::pair<std::int64_t, std::int64_t>>& labels,
                           const Levels& iso, std::optional<double> smooth, const Merges& merges) {
  Image image = image_of(array, spacing, origin, direction);
  return made([&](const Context& context) -> PythonSolid {
    const std::optional<double> level = prepare(image, iso, merges);
    auto kept = std::make_shared<const Image>(std::move(image));
    if (level) return {level_solid(std::move(kept), *level)};
    if (smooth == 0.0) return {label_solid(std::move(kept), ranges_of(labels))};
    return {interface_solid(std::move(kept), ranges_of(labels), {smooth}, context)};
  });
}

template <Solid (*combine)(const Solid&, const Solid&)>
PythonSolid combined(const PythonSolid& a, const PythonSolid& b) {
  PythonSolid result{combine(a.solid, b.solid), a.notes, std::max(a.cost, b.cost)};
  result.notes.insert(result.notes.end(), b.notes.begin(), b.notes.end());
  return result;
}

py::array_t<bool> are_inside(const PythonSolid& solid, const PointArray& points) {
  std::vector<Point3> world(static_cast<std::size_t>(points.shape(0)));
  for (std::size_t i = 0; i < world.size(); ++i)
    for (std::size_t a = 0; a < 3; ++a) world[i][a] = points.data()[3 * i + a];
  std::vector<std::uint8_t> found;
  Context context;
  run(context, [&] { found = inside(solid.solid, world); });
  py::array_t<bool> result(static_cast<py::ssize_t>(found.size()));
  std::ranges::transform(found, result.mutable_data(), [](std::uint8_t is) { return is != 0; });
  return result;
}

std::shared_ptr<PythonMesh> mesh_solid(const PythonSolid& given, double size, int margin,
                                       const Options& options) {
  return mesh_of(
      [&](const Context&) {
        Shape shape{{"solid", [solid = given.solid, margin](double at) {
                       return solid_domain(solid, at, margin);
                     }}};
        shape.notes = given.notes;
        shape.sized.cost = given.cost;
        shape.sized.pieces = unknown_pieces;
        return shape;
      },
      size, options);
}

/// A name, a solid, and whether its labels stay apart.
using NamedOne = std::tuple<std::string, PythonSolid, bool>;

std::shared_ptr<PythonMesh> mesh_solids(const std::vector<NamedOne>& given,
                                        const std::vector<std::string>& priority, double size,
                                        int margin, const Options& options) {
  return mesh_of(
      [&](const Context&) {
        Shape shape;
        const auto solids = std::make_shared<std::vector<NamedSolid>>();
        for (const auto& [name, one, keeps_labels] : given) {
          solids->push_back({name, one.solid, keeps_labels});
          std::ranges::copy(one.notes, std::back_inserter(shape.notes));
          shape.sized.name += (shape.sized.name.empty() ? "" : ", ") + name;
          shape.sized.cost = std::max(shape.sized.cost, one.cost);
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
  py::class_<PythonSolid>(module, "Solid")
      .def("__and__", combined<operator&>)
      .def("__or__", combined<operator|>)
      .def("__sub__", combined<operator- >)
      .def_property_readonly("low", [](const PythonSolid& one) { return one.solid.bounds.low; })
      .def_property_readonly("high", [](const PythonSolid& one) { return one.solid.bounds.high; })
      .def_property_readonly("notes", [](const PythonSolid& one) { return one.notes; });
  module.def("solid_of_function", solid_of_function);
  module.def("solid_of_surface", solid_of_surface);
  module.def("solid_of_text", [](const std::string& text,
                                 const std::optional<std::pair<Point3, Point3>>& bounds) {
    std::optional<Bounds> box;
    if (bounds) box = Bounds{bounds->first, bounds->second};
    return solid_of_text(text, box);
  });
  module.def("solid_of_image", solid_of_image);
  module.def("inside", are_inside);
  module.def("mesh_solid", mesh_solid);
  module.def("mesh_solids", mesh_solids);
}

}  // namespace certet::python
