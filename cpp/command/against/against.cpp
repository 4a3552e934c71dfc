#include "against.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "certet/error.hpp"
#include "mesh/mesh_memory.hpp"
#include "mesh/mesh_options.hpp"
#include "mesh/solid_choice.hpp"
#include "mesh/solid_source.hpp"

namespace certet::command {
namespace {

Bounds bounds_around(const FileMesh& mesh) {
  constexpr double more = 1.0 / 3;
  if (mesh.points.empty())
    throw Error(ErrorCode::empty_domain, "the mesh has no surface to measure distances from");
  Bounds box{mesh.points.front(), mesh.points.front()};
  for (const Point3& point : mesh.points)
    for (std::size_t a = 0; a < 3; ++a) {
      box.low[a] = std::min(box.low[a], point[a]);
      box.high[a] = std::max(box.high[a], point[a]);
    }
  const double aside = more * longest_side(box);
  for (std::size_t a = 0; a < 3; ++a) {
    box.low[a] -= aside;
    box.high[a] += aside;
  }
  return box;
}

}  // namespace

void declare_against(CLI::App& app, std::string& text) {
  app.add_option("--against", text,
                 "A file, formula or shape, as --material of `certet mesh` names them: tells how "
                 "far the surface of the mesh is from its surface, and back")
      ->option_text("SHAPE");
}

Solid open_against(const std::string& text, const FileMesh& mesh, const Context& context) {
  const SolidChoice choice = parse_solid(text);
  MeshOptions options;
  if (!choice.formula.empty()) options.bounds = bounds_around(mesh);
  const bool keeps_labels = choice.is_image() && !choice.iso && !mesh.labels.empty();
  return open_solid(choice, keeps_labels, options, memory_limit(options), context).solid;
}

DistanceReport distance_from(const std::string& text, const FileMesh& mesh, const Survey& survey,
                             double edge, Context& context) {
  const Solid solid = open_against(text, mesh, context);
  DistanceReport report{measure_distance(mesh.points, survey, solid, edge, context), {}};
  report.against = "that of " + text + (report.figures.exact ? ", by its triangles" : "");
  return report;
}

std::vector<double> distances_from(const std::string& text, const FileMesh& mesh,
                                   std::span<const Point3> points, Context& context) {
  const Solid solid = open_against(text, mesh, context);
  const double edge = mean_edge(surface_of(mesh.points, survey(mesh, context), false));
  return certet::distances_from(*solid_domain(solid, edge), false, points, context);
}

}  // namespace certet::command
