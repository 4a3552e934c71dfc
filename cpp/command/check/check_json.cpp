#include <fmt/format.h>

#include <algorithm>

#include "check_report.hpp"
#include "curved.hpp"
#include "json.hpp"
#include "pieces.hpp"

namespace certet::command {
namespace {

Json json_of(const ManifoldFaults& faults) {
  return {{"edges", faults.edges}, {"vertices", faults.vertices}};
}

Json json_of(const RegionReport& region, const LabelNames& names) {
  return {{"label", region.label},
          {"name", name_of(region.label, names)},
          {"tets", region.quality.tets},
          {"volume", region.quality.volume},
          {"dihedral",
           {{"min", region.quality.min_dihedral}, {"max", region.quality.max_dihedral}}},
          {"pieces", region.pieces.by_faces},
          {"pieces_by_vertices", region.pieces.by_vertices},
          {"surface",
           {{"faces", region.faces},
            {"area", region.area},
            {"open_edges", region.open_edges},
            {"nonmanifold", json_of(region.nonmanifold)}}}};
}

Json json_of(const InterfaceReport& interface, const LabelNames& names) {
  return {{"labels", interface.labels},
          {"names", {name_of(interface.labels[0], names), name_of(interface.labels[1], names)}},
          {"triangles", interface.triangles},
          {"area", interface.area},
          {"border_edges", interface.border_edges},
          {"loose_edges", interface.loose_edges},
          {"nonmanifold", json_of(interface.nonmanifold)}};
}

Json json_of(const SurfaceReport& surface) {
  Json json = {{"number", surface.number},   {"name", surface.name},
               {"triangles", surface.triangles}, {"outer", surface.outer},
               {"between", surface.between}, {"elsewhere", surface.elsewhere}};
  if (!surface.interface) return json;
  json["interface"] = *surface.interface;
  json["missing"] = surface.missing;
  json["wrong"] = surface.wrong;
  return json;
}

}  // namespace

std::string json(const CheckedFile& checked) {
  const CheckReport& report = checked.report;
  Json json = json_of_command("check");
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
  if (checked.curved) json["order2"] = json_of(*checked.curved);
  if (checked.distance) json["distance"] = json_of(*checked.distance);
  for (const RegionReport& region : checked.regions)
    json["regions"].push_back(json_of(region, checked.names));
  for (const InterfaceReport& interface : checked.interfaces)
    json["interfaces"].push_back(json_of(interface, checked.names));
  for (const SurfaceReport& surface : checked.surfaces)
    json["surfaces"].push_back(json_of(surface));
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
