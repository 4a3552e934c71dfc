#include <fmt/format.h>

#include "json.hpp"
#include "mesh_report.hpp"
#include "patch_options.hpp"
#include "pieces.hpp"

namespace certet::command {
namespace {

/// 64 bits do not fit the numbers of every JSON reader.
std::string hexadecimal(std::uint64_t number) { return fmt::format("0x{:016x}", number); }

Json guarantee(const MeshReport& report) {
  const AngleBounds bounds = bounds_of(report);
  Json json{{"asked", name(report.asked)},
            {"used", name(report.used)},
            {"theorem", bounds.theorem},
            {"min_dihedral", bounds.min_dihedral},
            {"max_dihedral", bounds.max_dihedral},
            {"inverted_tets", report.inverted_tets}};
  if (!report.dry_run) json["holds"] = standing(report) == Standing::within;
  if (report.moved()) json["angles"] = "checked";
  if (report.cut_apart) json["surface"] = surface_of_several;
  return json;
}

Json lengths(const ShiftLengths& world, const ShiftLengths& edges) {
  return {{"greatest", world.greatest},
          {"rms", world.rms},
          {"greatest_edges", edges.greatest},
          {"rms_edges", edges.rms}};
}

Json method(const MeshReport& report) {
  Json json{{"name", name(report.used)}};
  if (!facts(report.used).settles) return json;
  const WarpFigures& warp = report.warp;
  const ShiftLengths edges = shift_in_edges(warp);
  const ShiftLengths world = shift_in_world(warp, report.size);
  json["violated"] = warp.violated;
  json["stayed"] = warp.stayed;
  json["shortened"] = warp.shortened;
  json["missed"] = lengths(missed_by(warp, report.size), missed_by(warp, 1));
  json["clamped"] = lengths(world, edges);
  json["clamped"]["cuts"] = world.cuts;
  return json;
}

Json seconds(const MeshReport& report) {
  Json json{{"read", report.read_seconds},
            {"sample", report.sample_seconds},
            {"cut", report.cut_seconds},
            {"warp", report.warp_seconds},
            {"count", report.count_seconds},
            {"pieces", report.pieces_seconds}};
  if (report.distance) json["distance"] = report.distance_seconds;
  if (report.optimised) json["optimise"] = report.optimise_seconds;
  if (report.features.figures) json["features"] = report.features_seconds;
  if (!report.dry_run) {
    json["emit"] = report.written.emit_seconds;
    json["measure"] = report.written.measure_seconds;
    json["write"] = report.written.write_seconds;
  }
  json["total"] = report.total_seconds;
  return json;
}

Json regions(const MeshReport& report) {
  Json all = Json::array();
  for (const auto& [region, tets, volume, voxel_volume, change, pieces] : report.regions) {
    Json one{{"label", region.label}, {"voxels", region.voxels}};
    if (const auto name = report.names.find(region.label); name != report.names.end())
      one["name"] = name->second;
    if (!report.dry_run) one["tets"] = tets;
    if (volume > 0) {
      one["volume"] = report.out(volume);
      one["voxel_volume"] = report.out(voxel_volume);
    }
    if (change) one["change_percent"] = 100 * *change;
    if (pieces) {
      one["pieces"] = pieces->by_faces;
      one["pieces_by_vertices"] = pieces->by_vertices;
    }
    if (report.counted_pieces) {
      if (!pieces) one["pieces"] = region.lattice_pieces;
      one["image_pieces"] = {{"by_corners", region.pieces_by_corners},
                             {"by_faces", region.pieces_by_faces}};
    }
    all.push_back(one);
  }
  return all;
}

/// Of several solids.
Json regions_of_materials(const MeshReport& report) {
  Json all = Json::array();
  for (const auto& [label, name, tets, volume, solid, pieces] : report.materials) {
    Json one{{"label", label}, {"name", name}};
    if (!report.dry_run) {
      one["tets"] = tets;
      one["volume"] = report.out(volume);
    }
    one["solid_volume"] = report.out(solid.volume);
    if (pieces) {
      one["pieces"] = pieces->by_faces;
      one["pieces_by_vertices"] = pieces->by_vertices;
    }
    all.push_back(one);
  }
  return all;
}

Json ranks(const std::vector<RankReport>& ranks) {
  Json all = Json::array();
  for (const auto& [layers, points, tets, memory_peak, seconds] : ranks)
    all.push_back({{"layers", layers}, {"points", points}, {"tets", tets},
                   {"memory_peak", memory_peak}, {"processor_seconds", seconds}});
  return all;
}

Json smoothing(const MeshReport& report) {
  const Smoothing& smoothing = *report.smoothing;
  Json json{{"voxel_volume", report.out(smoothing.voxel_volume)}};
  if (smoothing.sigma) json["sigma"] = *smoothing.sigma;
  if (report.dry_run) return json;
  json["mesh_volume"] = report.out(report.written.world.volume);
  json["change"] = report.written.world.volume / smoothing.voxel_volume - 1;
  return json;
}

}  // namespace

std::string json(const MeshReport& report) {
  const WrittenMesh& written = report.written;
  Json json = json_of_command("mesh");
  json["dry_run"] = report.dry_run;
  json["input"] = {{"kind", report.input_kind},
                   {"name", report.formula.empty() ? report.input_name : report.formula},
                   {"notes", report.input_notes}};
  if (!report.inside.empty()) json["input"]["inside"] = report.inside;
  if (!report.without.empty()) json["input"]["subtract"] = report.without;
  json["output"] = {
      {"file", report.output}, {"format", report.format}, {"bytes", report.output_bytes},
      {"origin", report.output_origin},
      {"frame", report.axes ? name(*report.axes) : "input"}, {"scale", report.scale}};
  json["lattice"] = {
      {"cells", report.cells}, {"size", report.size}, {"cuts", name(facts(report.used).cuts)}};
  if (report.target_tets != 0) {
    json["lattice"]["target_tets"] = report.target_tets;
    json["lattice"]["tries"] = report.tries;
  }
  json["method"] = method(report);
  json["mesh"] = {{"points", report.points}, {"tets", report.tets}};
  if (report.graded.levels != 0)
    json["mesh"]["graded"] = json_of(report.graded, report.size * report.scale);
  if (!report.dry_run) {
    json["mesh"]["volume"] = report.out(written.world.volume);
    if (report.room) json["mesh"]["volume_fraction"] = written.world.volume / *report.room;
    json["mesh"]["checksum"] = hexadecimal(written.checksum);
    json["mesh"]["file_checksum"] = hexadecimal(written.file_checksum);
    json["dihedral"] = {{"min", written.world.min_dihedral},
                        {"max", written.world.max_dihedral},
                        {"lattice_min", written.lattice.min_dihedral},
                        {"lattice_max", written.lattice.max_dihedral},
                        {"rounding", written.rounding},
                        {"histogram", written.lattice.histogram}};
  }
  if (report.optimised)
    json["optimised"] = json_of(*report.optimised, report.size * report.scale);
  json["features"] = json_of(report.features, report.size * report.scale);
  if (report.order) json["order2"] = json_of(*report.order, report.size * report.scale);
  if (report.knows_pieces) add_pieces(json["mesh"], report.pieces);
  if (!report.patches.empty()) json["patches"] = json_of(report.patches);
  if (report.distance) json["distance"] = json_of(*report.distance);
  if (!report.keep.empty())
    json["dropped"] = {{"keep", report.keep},
                       {"pieces", report.dropped.pieces},
                       {"kept", report.dropped.kept},
                       {"tets", report.dropped.tets},
                       {"volume", report.out(report.dropped.volume)}};
  json["theorem"] = bounds_of(report).theorem;
  json["guarantee"] = guarantee(report);
  json["seconds"] = seconds(report);
  json["warnings"] = report.warnings;
  if (report.uncompared)
    json["losses"] = {{"not_compared", sentence_on(*report.uncompared)},
                      {"size", report.uncompared->size},
                      {"cells", report.uncompared->cells}};
  if (!report.regions.empty()) json["regions"] = regions(report);
  if (!report.materials.empty()) json["regions"] = regions_of_materials(report);
  if (report.smoothing) json["smoothing"] = smoothing(report);
  json["memory"] = {{"limit", report.memory_limit},
                    {"needed", report.memory_needed},
                    {"least", report.memory_least},
                    {"peak", report.memory_peak}};
  if (!report.ranks.empty()) json["ranks"] = ranks(report.ranks);
  return print(json);
}

}  // namespace certet::command
