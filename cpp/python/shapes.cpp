#include "shapes.hpp"

#include <string>
#include <utility>

#include "certet/curve.hpp"
#include "certet/error.hpp"
#include "certet/stuffing.hpp"
#include "certet/survey.hpp"
#include "certet/target_size.hpp"
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

void grade(const Options& options, const Frame& frame, Stuffing& stuffing, Context& context) {
  if (options.grade == 0) return;
  Grading grading;
  grading.levels = options.grade;
  if (options.sizes) keep_within(*options.sizes, frame, grading);
  stuffing.grade(grading, context);
}

/// At the size that was asked for, or at one that gives as many tetrahedra as were.
CountedShape count(const SizedShape& shape, double size, const Options& options,
                   Context& context) {
  const auto count_at = [&](double at) -> CountedShape {
    const std::shared_ptr<const PlacedDomain> domain = shape.place(at);
    Stuffing stuffing(*domain, domain->lattice(), options.method, context);
    grade(options, domain->frame(), stuffing, context);
    return {domain, std::move(stuffing)};
  };
  if (options.target_tets == 0) return count_at(size);
  int tries = 0;
  return count_near(options.target_tets, shape.place(0)->longest_side(), count_at,
                    [](const CountedShape& one) { return one.stuffing.tet_count(); }, tries);
}

/// Leaves out the pieces that are not to stay.
void drop_pieces(const Options& options, CountedShape& counted, Context& context,
                 PythonMesh& result) {
  if (!options.keep) return;
  const Frame& frame = counted.domain->frame();
  const Stuffing rest = counted.stuffing.keep(*options.keep, context);
  grade(options, frame, counted.stuffing, context);
  result.dropped = {rest.pieces(frame, context).whole.by_faces, rest.tet_count(),
                    volume_of(rest, frame, context)};
  if (rest.tet_count() > 0 && counted.stuffing.tet_count() == 0)
    throw Error(ErrorCode::empty_domain,
                "none of the " + std::to_string(result.dropped->pieces) + " pieces is kept");
}

/// Moves vertices, for better angles or onto sharp edges.
void move(const Options& options, const PlacedDomain& domain, Context& context,
          PythonMesh& result) {
  if (options.optimise != 0)
    result.optimised = optimise(result.mesh, domain, {options.optimise}, context);
  result.features = decide_features(options.features, domain, options.method);
  if (options.grade != 0) {
    result.features.angle.reset();
    result.features.why = "the mesh is graded";
  }
  if (!result.features.angle) return;
  result.kept = keep_features(result.mesh, domain, *result.features.angle, context);
  if (!result.kept->all_followed()) result.warnings.push_back(sentence_on(*result.kept));
}

/// Looks for what the mesh has not kept; pieces that were dropped are no loss.
void tell_losses(const Shape& shape, const CountedShape& counted, const Options& options,
                 Context& context, PythonMesh& result) {
  const auto& [domain, stuffing] = counted;
  const DroppedPieces dropped = result.dropped.value_or(DroppedPieces{});
  MeshedShape meshed{*domain, options.method, stuffing.tet_count(),
                     volume_of(stuffing, domain->frame(), context) + dropped.volume};
  if (dropped.pieces == 0) meshed.pieces = stuffing.pieces(domain->frame(), context).whole;
  const Losses losses = find_losses(shape.sized, meshed, context);
  result.losses = sentences_on(losses, shape.sized, "size=");
  if (losses.uncompared) result.notes.push_back(sentence_on(*losses.uncompared));
}

/// Counts a mesh and makes it.
void fill(const Shape& shape, double size, const Options& options, Context& context,
          PythonMesh& result) {
  CountedShape counted = count(shape.sized, size, options, context);
  drop_pieces(options, counted, context, result);
  const PlacedDomain& domain = *counted.domain;
  result.mesh = mesh(domain, counted.stuffing, context);
  move(options, domain, context, result);
  if (options.order == 2) result.middles = middles_of(result.mesh, domain, options, context);
  result.warp = counted.stuffing.warp_figures();
  result.notes = shape.notes;
  tell_losses(shape, counted, options, context, result);
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
  }, options.follow);
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
