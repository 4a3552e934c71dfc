#include "distance.hpp"

namespace certet::command {
namespace {

Json json_of(const Distance& distance, double edge) {
  return {{"greatest", distance.greatest},
          {"rms", distance.rms},
          {"greatest_edges", distance.greatest / edge},
          {"rms_edges", distance.rms / edge},
          {"at", distance.at},
          {"points", distance.points}};
}

Distance one_of(const Json& json) {
  return {json.at("greatest").get<double>(), json.at("rms").get<double>(),
          json.at("at").get<Point3>(), json.at("points").get<std::uint64_t>()};
}

}  // namespace

std::string sentence(const Distance& distance, double edge) {
  const auto& [x, y, z] = distance.at;
  return fmt::format("greatest {:.4f} edges ({:.4g}) at ({:.6g}, {:.6g}, {:.6g}), rms {:.4f} ({:.4g})",
                     distance.greatest / edge, distance.greatest, x, y, z, distance.rms / edge,
                     distance.rms);
}

void add_distance(Lines& lines, const DistanceReport& report) {
  const DistanceFigures& found = report.figures;
  lines.add("distance", "mesh to shape: {}", sentence(found.to_shape, found.edge));
  lines.add("", "shape to mesh: {}", sentence(found.to_mesh, found.edge));
  lines.add("", "the shape's surface is {}", report.against);
}

Json json_of(const DistanceReport& report) {
  const DistanceFigures& found = report.figures;
  return {{"against", report.against},
          {"exact", found.exact},
          {"edge", found.edge},
          {"to_shape", json_of(found.to_shape, found.edge)},
          {"to_mesh", json_of(found.to_mesh, found.edge)}};
}

DistanceReport distance_of(const Json& json) {
  DistanceReport report;
  report.against = json.at("against").get<std::string>();
  report.figures = {one_of(json.at("to_shape")), one_of(json.at("to_mesh")),
                    json.at("edge").get<double>(), json.at("exact").get<bool>()};
  return report;
}

std::vector<PageRow> page_rows(const DistanceReport& report) {
  const DistanceFigures& found = report.figures;
  return {{"mesh to shape", sentence(found.to_shape, found.edge)},
          {"shape to mesh", sentence(found.to_mesh, found.edge)},
          {"the shape", "its surface is " + report.against}};
}

}  // namespace certet::command
