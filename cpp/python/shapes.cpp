#include "shapes.hpp"

#include <utility>

#include "certet/curve.hpp"
#include "certet/error.hpp"
#include "certet/stuffing.hpp"
#include "certet/survey.hpp"
#include "run.hpp"

namespace certet::python {

namespace {

PythonMiddles middles_of(const Mesh& mesh, const Domain& domain, const Options& options,
                         Context& context) {
  MiddleNodes nodes = middle_nodes(mesh, context);
  std::optional<CurveFigures> curved;
  if (options.curved) curved = curve(nodes, mesh, survey(mesh, context), domain, context);
  return placed(mesh, std::move(nodes), curved);
}

/// Counts a mesh and makes it, and looks for what it has not kept.
void fill(const Shape& shape, double size, const Options& options, Context& context,
          PythonMesh& result) {
  const std::shared_ptr<const PlacedDomain> domain = shape.sized.place(size);
  Stuffing stuffing(*domain, domain->lattice(), options.method, context);
  if (options.grade != 0) {
    Grading grading;
    grading.levels = options.grade;
    if (options.sizes) keep_within(*options.sizes, domain->frame(), grading);
    stuffing.grade(grading, context);
  }
  result.mesh = mesh(*domain, stuffing, context);
  if (options.optimise != 0)
    result.optimised = optimise(result.mesh, *domain, {options.optimise}, context);
  result.features = decide_features(options.features, *domain, options.method);
  if (options.grade != 0) {
    result.features.angle.reset();
    result.features.why = "the mesh is graded";
  }
  if (result.features.angle)
    result.kept = keep_features(result.mesh, *domain, *result.features.angle, context);
  if (result.kept && !result.kept->all_followed()) result.warnings.push_back(sentence_on(*result.kept));
  if (options.order == 2) result.middles = middles_of(result.mesh, *domain, options, context);
  result.warp = stuffing.warp_figures();
  result.notes = shape.notes;
  const MeshedShape meshed{*domain, options.method, stuffing.tet_count(),
                           volume_of(stuffing, domain->frame(), context),
                           stuffing.pieces(domain->frame(), context).whole};
  const Losses losses = find_losses(shape.sized, meshed, context);
  result.losses = sentences_on(losses, shape.sized, "size=");
  if (losses.uncompared) result.notes.push_back(sentence_on(*losses.uncompared));
}

}  // namespace

PythonMiddles placed(const Mesh& mesh, MiddleNodes nodes, std::optional<CurveFigures> curved) {
  PythonMiddles middles{std::move(nodes), {}, {}, curved};
  middles.points = middle_points(mesh, middles.nodes);
  middles.of_tets.reserve(mesh.tet_count());
  std::visit(
      [&](const auto& tets) {
        for (const auto& tet : tets) middles.of_tets.push_back(middles.nodes.of(tet));
      },
      mesh.tets);
  return middles;
}

std::shared_ptr<PythonMesh> mesh_of(const std::function<Shape(const Context&)>& make, double size,
                                    const Options& options) {
  auto result = std::make_shared<PythonMesh>();
  Context context;
  context.threads = options.threads;
  run(context, [&] {
    const Shape shape = make(context);
    fill(shape, size, options, context, *result);
    if (shape.warnings)
      for (std::string& warning : shape.warnings(result->mesh))
        result->warnings.push_back(std::move(warning));
    result->world = world_points(result->mesh);
  });
  return result;
}

std::optional<PieceBounds> unknown_pieces(Context&) { return std::nullopt; }

TriangleSurface surface_of(const PointArray& points, const TriangleArray& triangles,
                           std::string name) {
  TriangleSurface surface;
  surface.name = std::move(name);
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
  return surface;
}

MendedSurface mend(TriangleSurface surface, bool close_holes) {
  const SurfaceRepairs repairs = repair_surface(surface, {close_holes});
  const bool open = repairs.closed_holes.count != 0;
  if (open) refuse_unclear(surface);
  else if (!is_closed(surface))
    refuse_open(surface, inspect(surface), close_holes ? "" : "repair=True closes what is open");
  return {std::move(surface), open, sentences_on(repairs)};
}

}  // namespace certet::python
