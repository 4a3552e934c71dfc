#include <fmt/format.h>

#include "check_report.hpp"
#include "json.hpp"

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
  json["dihedral"] = {{"min", report.quality.min_dihedral},
                      {"max", report.quality.max_dihedral},
                      {"histogram", report.quality.histogram}};
  json["seconds"] = {{"read", checked.read_seconds},
                     {"check", checked.check_seconds},
                     {"total", checked.total_seconds}};
  json["memory"] = {{"peak", checked.memory_peak}};
  return print(json);
}

}  // namespace certet::command
