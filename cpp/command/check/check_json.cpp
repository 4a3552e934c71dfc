#include <fmt/format.h>

#include <algorithm>

#include "check_report.hpp"
#include "json.hpp"
#include "pieces.hpp"

namespace certet::command {

std::string json(const CheckedFile& checked) {
  const CheckReport& report = checked.report;
  Json json;
  json["certet"] = CERTET_VERSION;
  json["command"] = "check";
  json["file"] = checked.file;
  json["ok"] = report.failures.empty();
  json["failures"] = report.failures;
  json["mesh"] = {{"points", report.points},
                  {"tets", report.quality.tets},
                  {"volume", report.quality.volume},
                  {"checksum", fmt::format("0x{:016x}", checked.checksum)},
                  {"unused_points", report.unused_points},
                  {"nonfinite_points", report.nonfinite_points},
                  {"duplicate_points", report.duplicate_points},
                  {"bad_indices", report.bad_indices},
                  {"nonpositive_tets", report.quality.nonpositive},
                  {"overfull_faces", report.overfull_faces},
                  {"misoriented_faces", report.misoriented_faces},
                  {"boundary_faces", report.boundary_faces},
                  {"open_edges", report.open_edges}};
  add_pieces(json["mesh"], checked.pieces);
  for (const auto& [label, pieces] : checked.pieces.regions)
    json["regions"].push_back({{"label", label},
                               {"pieces", pieces.by_faces},
                               {"pieces_by_vertices", pieces.by_vertices}});
  json["dihedral"] = {{"min", report.quality.min_dihedral},
                      {"max", report.quality.max_dihedral},
                      {"histogram", report.quality.histogram}};
  const AngleBounds bounds = checked.run ? checked.run->bounds : checked.asked;
  json["bounds"] = {{"min", std::max(bounds.min_dihedral, checked.asked.min_dihedral)},
                    {"max", std::min(bounds.max_dihedral, checked.asked.max_dihedral)}};
  if (checked.run && report.failures.empty()) json["bounds"]["theorem"] = bounds.theorem;
  json["seconds"] = {{"read", checked.read_seconds},
                     {"check", checked.check_seconds},
                     {"total", checked.total_seconds}};
  json["memory"] = {{"peak", checked.memory_peak}};
  return print(json);
}

}  // namespace certet::command
