#include <algorithm>
#include <cmath>

#include "mesh_report.hpp"
#include "patch_options.hpp"
#include "pieces.hpp"
#include "table.hpp"

namespace certet::command {
namespace {

/// Why a mesh was not made by the method that was asked for.
std::string why_another(const MeshReport& report) {
  if (report.used == report.asked) return "";
  if (report.cut_apart)
    return fmt::format(" ({} is of one material, and here several meet)", name(report.asked));
  return fmt::format(" ({} inverted {} dropped tetrahedra)", name(report.asked),
                     grouped(report.inverted_tets));
}

/// Nothing is called proven that was not measured.
void add_method(Lines& lines, const MeshReport& report) {
  const MethodFacts& method = facts(report.used);
  lines.add(report.dry_run ? "bounds" : "proven", "{:.3f}° to {:.3f}°, theorem {}{}",
            method.bounds.min_dihedral, method.bounds.max_dihedral, bounds_of(report).theorem,
            report.dry_run ? "; no angle was measured" : "");
  if (report.moved())
    lines.add("checked", "{:.3f}° to {:.3f}°, once vertices had moved, none of which let an angle "
              "leave {}",
              report.written.lattice.min_dihedral, report.written.lattice.max_dihedral,
              report.features.figures ? "these bounds" : "what the others had");
  // What is proved of one solid besides its angles is not of several.
  lines.add("method", "{}: {}{}{}", method.name,
            report.cut_apart
                ? fmt::format("labels are cut apart, each keeps its pieces; surfaces are {}",
                              surface_of_several)
                : std::string(method.sentence),
            report.moved() ? "; this is of the mesh before vertices moved" : "",
            why_another(report));
}

/// What settling did to the surface.
void add_settling(Lines& lines, const MeshReport& report) {
  if (!facts(report.used).settles) return;
  const WarpFigures& warp = report.warp;
  const ShiftLengths edges = shift_in_edges(warp);
  const ShiftLengths world = shift_in_world(warp, report.size);
  lines.add("", "{} of {} vertices too close to the surface stayed, {} moves shortened",
            grouped(warp.stayed), grouped(warp.violated), grouped(warp.shortened));
  if (const ShiftLengths missed = missed_by(warp, 1); missed.cuts != 0)
    lines.add("", "shortened ones miss the surface by at most {:.3f} edges ({:.4g}), rms {:.3f} ({:.4g})",
              missed.greatest, missed.greatest * report.size, missed.rms,
              missed.rms * report.size);
  if (world.cuts != 0)
    lines.add("", "{} cuts moved by at most {:.3f} edges ({:.4g}), rms {:.3f} ({:.4g})",
              grouped(world.cuts), edges.greatest, world.greatest, edges.rms, world.rms);
}

void add_ranks(Lines& lines, const std::vector<RankReport>& ranks) {
  if (ranks.empty()) return;
  const auto [least, most] = std::ranges::minmax(ranks, {}, &RankReport::tets);
  lines.add("ranks", "{}, of {} to {} tetrahedra", ranks.size(), grouped(least.tets),
            grouped(most.tets));
}

void add_pieces(Lines& lines, const MeshReport& report) {
  if (!report.knows_pieces) return lines.add("pieces", "not counted by several ranks");
  const DroppedPieces& dropped = report.dropped;
  if (!report.keep.empty())
    lines.add("dropped", "{} of {} pieces: {} tetrahedra, volume {:.6g}", grouped(dropped.pieces),
              grouped(dropped.pieces + dropped.kept), grouped(dropped.tets),
              report.out(dropped.volume));
  lines.add("pieces", "{}", sentence(report.pieces, report.tets));
  if (report.uncompared) lines.add("losses", "{}", sentence_on(*report.uncompared));
  if (report.pieces.surface.vertices > 0)
    lines.add("surface", "{}", sentence(report.pieces.surface));
}

/// Of labels that are not small, the volume that differs most from that of its voxels.
std::string volumes_told(const std::vector<MeshedRegion>& regions) {
  constexpr std::uint64_t least_voxels = 1000;
  const MeshedRegion* most = nullptr;
  for (const MeshedRegion& one : regions)
    if (one.change && one.region.voxels >= least_voxels &&
        (most == nullptr || std::abs(*one.change) > std::abs(*most->change)))
      most = &one;
  if (most == nullptr) return "";
  return fmt::format("; of {} voxels and more, label {} differs most from their volume, by {:+.2f} %",
                     grouped(least_voxels), most->region.label, 100 * *most->change);
}

void add_regions(Lines& lines, const MeshReport& report) {
  const auto present = std::count_if(report.regions.begin(), report.regions.end(),
                                     [](const MeshedRegion& region) { return region.tets > 0; });
  if (!report.regions.empty() && report.input_kind == "labels" && !report.dry_run)
    lines.add("labels", "{} of {} in the mesh{}", present, report.regions.size(),
              volumes_told(report.regions));
  for (const MeshedMaterial& one : report.materials)
    lines.add("material", "{} {}{}{}", one.label, one.name,
              report.dry_run ? ""
                             : fmt::format(": {} tetrahedra, volume {:.6g}", grouped(one.tets),
                                           report.out(one.volume)),
              !one.pieces ? ""
              : one.pieces->by_faces == 1
                  ? ", 1 piece"
                  : fmt::format(", {} pieces", grouped(one.pieces->by_faces)));
  for (const std::string& warning : report.warnings) lines.add("warning", "{}", warning);
}

}  // namespace

std::string table(const MeshReport& report) {
  Lines lines;
  lines.add("input", "{} ({})", report.input_name, report.input_kind);
  for (const std::string& solid : report.inside) lines.add("inside", "{}", solid);
  for (const std::string& solid : report.without) lines.add("subtracted", "{}", solid);
  for (const std::string& note : report.input_notes) lines.add("note", "{}", note);
  if (!report.output.empty() || report.dry_run)
    lines.add("output", "{} ({}, {}){}",
              report.output.empty() ? "none" : report.output, report.format,
              bytes(report.output_bytes), report.dry_run ? ", not written" : "");
  if (report.output_origin != Point3{})
    lines.add("origin", "0 in the output is ({:.17g}, {:.17g}, {:.17g}) in the world",
              report.output_origin[0], report.output_origin[1], report.output_origin[2]);
  if (report.axes)
    lines.add("frame", "{}: x to the {}, y to the {}, z to the head", space(*report.axes),
              *report.axes == PatientAxes::lps ? "left" : "right",
              *report.axes == PatientAxes::lps ? "back" : "front");
  if (report.scale != 1) lines.add("scale", "{:.9g}, of coordinates and volumes", report.scale);
  lines.add("lattice", "{} x {} x {} cells of size {:.6g}, cuts {}", report.cells[0],
            report.cells[1], report.cells[2], report.size, name(facts(report.used).cuts));
  if (report.target_tets != 0)
    lines.add("target", "{} tetrahedra, size found in {} tries", grouped(report.target_tets),
              report.tries);
  lines.add("mesh", "{} points, {} tetrahedra", grouped(report.points), grouped(report.tets));
  add_grade(lines, report.graded, report.tets, report.size * report.scale);
  if (report.optimised)
    add_optimise(lines, *report.optimised, report.size * report.scale);
  add_features(lines, report.features, report.size * report.scale);
  if (report.order) add_order(lines, *report.order, report.size * report.scale);
  add_pieces(lines, report);
  add_patches(lines, report.patches);
  add_regions(lines, report);
  if (report.distance) add_distance(lines, *report.distance);
  if (!report.dry_run) {
    lines.add("volume", "{:.9g}", report.out(report.written.world.volume));
    if (report.room)
      lines.add("fraction", "{:.2f} % of its box", 100 * report.written.world.volume / *report.room);
    if (report.smoothing)
      lines.add("smoothing", "sigma {}, volume of the voxels {:.9g}, change {:+.2f} %",
                report.smoothing->sigma ? fmt::format("{:.6g}", *report.smoothing->sigma)
                                        : "one voxel",
                report.out(report.smoothing->voxel_volume),
                100 * (report.written.world.volume / report.smoothing->voxel_volume - 1));
    lines.add("checksum", "0x{:016x}", report.written.checksum);
    add_angles(lines, report.written.world);
    // In exact coordinates an angle on the edge between two bins is in its own.
    add_histogram(lines, report.written.lattice);
  }
  add_method(lines, report);
  add_settling(lines, report);
  lines.add("seconds", "read {:.2f}, sample {:.2f}, cut {:.2f}, warp {:.2f}, count {:.2f}, "
            "pieces {:.2f}{}{}",
            report.read_seconds, report.sample_seconds, report.cut_seconds,
            report.warp_seconds, report.count_seconds, report.pieces_seconds,
            report.optimised ? fmt::format(", optimise {:.2f}", report.optimise_seconds) : "",
            report.features.figures ? fmt::format(", features {:.2f}", report.features_seconds)
                                    : "");
  if (!report.dry_run)
    lines.add("", "emit {:.2f}, measure {:.2f}, write {:.2f}", report.written.emit_seconds,
              report.written.measure_seconds, report.written.write_seconds);
  if (report.distance) lines.add("", "distance {:.2f}", report.distance_seconds);
  lines.add("", "total {:.2f}", report.total_seconds);
  add_ranks(lines, report.ranks);
  lines.add("memory", "needed {}, peak {}, limit {}", bytes(report.memory_needed),
            bytes(report.memory_peak), bytes(report.memory_limit));
  return std::move(lines).text();
}

}  // namespace certet::command
