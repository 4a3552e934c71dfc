#include <algorithm>
#include <cstdio>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "certet/error.hpp"
#include "certet/label_names.hpp"
#include "certet/target_size.hpp"
#include "commands.hpp"
#include "counted.hpp"
#include "kept.hpp"
#include "measured_distance.hpp"
#include "memory.hpp"
#include "mesh_files.hpp"
#include "mesh_memory.hpp"
#include "mesh_options.hpp"
#include "mesh_report.hpp"
#include "output_place.hpp"
#include "outputs.hpp"
#include "patch_options.hpp"
#include "progress.hpp"
#include "regions.hpp"
#include "source.hpp"
#include "surface_choice.hpp"
#include "told_run.hpp"

namespace certet::command {
namespace {

[[noreturn]] void refuse_angles(const MeshReport& report) {
  const Quality& lattice = report.written.lattice;
  const AngleBounds bounds = bounds_of(report);
  const bool in_lattice = within(lattice, bounds, shown_rounding);
  const Quality& quality = in_lattice ? report.written.world : lattice;
  throw Error(ErrorCode::check_failed,
              fmt::format("'{}' was not written: {} has angles from {:.6f} to {:.6f} degrees and "
                          "{} tetrahedra that are flat or turned over, which {} rules out",
                          report.output, in_lattice ? "the mesh in the world" : "the mesh",
                          quality.min_dihedral, quality.max_dihedral, quality.nonpositive,
                          bounds.theorem));
}

/// The mesh is sound, but not where it is to be.
[[noreturn]] void refuse_place(const MeshReport& report) {
  const Quality& world = report.written.world;
  throw Error(
      ErrorCode::write_failed,
      fmt::format("cannot write '{}': so far from the origin double precision cannot hold the "
                  "mesh, whose angles would be from {:.6f} to {:.6f} degrees, with {} tetrahedra "
                  "flat or turned over and {} points upon others; --origin 0 writes it near 0",
                  report.output, world.min_dihedral, world.max_dihedral, world.nonpositive,
                  report.written.coincident_points));
}

void check_written(const MeshReport& report) {
  switch (standing(report)) {
    case Standing::within: return;
    case Standing::blurred: refuse_place(report);
    case Standing::outside: refuse_angles(report);
  }
}

/// Names those patches of the boundary that are to have names, and tells how large all are, unless
/// there is but the surface.
void look_at_patches(const MeshOptions& options, const Counted& counted, const Mesh* moved,
                     Survey& found, Context& context, MeshReport& report) {
  const auto is_surface = [](const BoundaryFace& face) { return face.patch == Patch::surface; };
  if (options.patches.empty() && std::ranges::all_of(found.boundary, is_surface)) return;
  const Frame frame = file_frame(options, report.axes, counted.source.frame);
  const BoundaryPoints points(found, counted.stuffing, frame,
                              moved == nullptr ? std::span<const Coord3>() : moved->points, context);
  const auto place = [&points](std::uint64_t point) { return points.at(point); };
  name_patches(found, options.patches, frame.size, place);
  report.patches = patch_figures(found, place);
}

/// What the format says of the mesh before its numbers.
MeshSize announce(const MeshOptions& options, const LabelNames& names, const Counted& counted,
                  const Mesh* moved, Context& context, MeshReport& report) {
  const Stuffing& stuffing = counted.stuffing;
  MeshSize size{stuffing.point_count(), stuffing.tet_count(), !stuffing.labels().empty()};
  if (!needs_survey(options.format)) return size;
  const Frame frame = output_frame(options, report.axes, counted.source.frame);
  auto found = std::make_shared<Survey>(survey(stuffing, context, frame));
  if (moved != nullptr && report.features.figures) find_sides(*found, *moved, frame);
  if (has_patches(options.format))
    look_at_patches(options, counted, moved, *found, context, report);
  name_regions(*found, names);
  choose_surface(options.surface, names, *found);
  size.survey = std::move(found);
  return size;
}

/// What it is compared with, at sizes whose lattices memory allows.
SizedShape sized(const MeshOptions& options, const Source& source, const Counted& counted,
                 std::uint64_t limit) {
  const auto place = [&options, &source, limit](double size) {
    PlacedSource placed = source.place(size);
    check_lattice(placed, options.method, limit);
    return std::move(placed.domain);
  };
  return {source.name, place, counted.source.volume, source.thin, source.pieces};
}

/// Where the domain is asked for the materials of tetrahedra, those that these had before their
/// corners moved.
MaterialRuns materials_of(const Counted& counted, const MeshSize& size,
                          std::span<const Coord3> moved, Context& context) {
  const Stuffing& stuffing = counted.stuffing;
  if (moved.empty() || size.survey != nullptr || stuffing.labels().empty() ||
      stuffing.has_interfaces())
    return {};
  return survey(stuffing, context).materials;
}

void write(const MeshOptions& options, const SizedShape& shape, const Counted& counted,
           const Slabs& slabs, const MeshSize& size, std::span<const Coord3> moved,
           Context& context, Progress& progress, MeshReport& report) {
  const auto& [source, stuffing] = counted;
  check_room(options.output, report.output_bytes);
  const auto file = open_writer(options.output, options.format, size);
  WatchedWriter writer(*file, size, progress);
  const Frame frame = file_frame(options, report.axes, source.frame);
  const MaterialRuns known = materials_of(counted, size, moved, context);
  report.written = write_mesh(stuffing, frame, slabs, writer, context,
                              size.survey == nullptr ? known : size.survey->materials,
                              options.label_pieces, size.middles.get(), moved);
  report.written.world.volume /= report.out(1);
  check_written(report);
  tell_losses(shape, counted, context, report);
  const Stopwatch finishing;
  writer.finish();
  report.written.write_seconds += finishing.seconds();
}

/// By the size that was asked for, or searching for it.
Counted count(const MeshOptions& options, const Source& source, Context& context,
              MeshReport& report) {
  check_target(options, report.memory_limit);
  const Stopwatch reading;
  const double side =
      options.relative_size != 0 || options.target_tets != 0 ? source.place(0).longest_side : 0;
  report.read_seconds += reading.seconds();
  const auto count_at = [&](double size) {
    PlacedSource placed = source.place(size);
    check_lattice(placed, options.method, report.memory_limit);
    Stuffing stuffing(*placed.domain, placed.lattice, options.method, context);
    grade(options.grade, placed.frame, stuffing, context);
    return Counted{std::move(placed), std::move(stuffing)};
  };
  if (options.target_tets != 0)
    return count_near(options.target_tets, side, count_at,
                      [](const Counted& one) { return one.stuffing.tet_count(); }, report.tries);
  return count_at(options.relative_size != 0 ? options.relative_size * side : options.size);
}

void describe(const MeshOptions& options, const Source& source, MeshReport& report) {
  report.dry_run = options.dry_run;
  report.input_kind = source.kind;
  report.input_name = source.name;
  report.formula = options.formula;
  for (const SolidChoice& solid : options.inside) report.inside.push_back(solid.text);
  for (const SolidChoice& solid : options.without) report.without.push_back(solid.text);
  report.input_notes = source.notes;
  report.smoothing = source.smoothing;
  report.output = options.output.string();
  report.format = name(options.format);
  report.target_tets = options.target_tets;
  report.asked = options.method;
  report.scale = options.scale;
  report.axes = output_axes(options, source);
}

void describe(const MeshOptions& options, const Counted& counted, const Progress& progress,
              MeshReport& report) {
  const auto& [source, stuffing] = counted;
  report.cells = source.lattice.cells;
  report.size = source.frame.size;
  report.room = source.room;
  if (options.origin == OutputOrigin::lattice) 
    report.output_origin = output_frame(options, report.axes, source.frame).origin;
  report.used = stuffing.method();
  report.cut_apart = stuffing.has_interfaces();
  report.inverted_tets = stuffing.inverted_tets();
  report.warp = stuffing.warp_figures();
  report.points = stuffing.point_count();
  report.tets = stuffing.tet_count();
  report.graded = {stuffing.grading_levels(), stuffing.uniform_tet_count(),
                   options.grade.size_field};
  report.sample_seconds = progress.seconds(Stage::sample);
  report.cut_seconds = progress.seconds(Stage::cut);
  report.warp_seconds = progress.seconds(Stage::warp);
  report.count_seconds = progress.seconds(Stage::count);
}

/// Moves vertices onto sharp edges, if they are to.
void keep_sharp(const MeshOptions& options, const Counted& counted, std::optional<Mesh>& made,
                Context& context, MeshReport& report) {
  const PlacedDomain& domain = *counted.source.domain;
  report.features = {name(options.features),
                     decide_features(options.features, domain, options.method), {}};
  if (report.graded.levels != 0) {
    report.features.decision.angle.reset();
    report.features.decision.why = "the mesh is graded";
  }
  if (!report.features.decision.angle || options.dry_run) return;
  const Stopwatch clock;
  if (!made && options.features.automatic && !can_move(counted, report)) {
    report.features.decision.angle.reset();
    report.features.decision.why = "the mesh does not fit the memory, in which vertices would move";
    return;
  }
  if (!made) {
    check_moving_memory(counted, "to keep sharp edges", report);
    made = mesh(domain, counted.stuffing, context);
  }
  report.features.figures =
      keep_features(*made, domain, *report.features.decision.angle, context);
  report.features_seconds = clock.seconds();
}

/// The mesh in memory once its vertices have moved, if they are to.
std::optional<Mesh> optimise(const MeshOptions& options, const Counted& counted, Context& context,
                             MeshReport& report) {
  if (!options.optimise.wanted || options.dry_run) return std::nullopt;
  check_moving_memory(counted, "to optimise the mesh", report);
  const Stopwatch clock;
  OptimiseFigures figures;
  Mesh moved =
      optimised(options.optimise, *counted.source.domain, counted.stuffing, context, figures);
  report.optimised = figures;
  report.optimise_seconds = clock.seconds();
  return moved;
}

/// Drops pieces, if that is asked for.
void drop_pieces(const MeshOptions& options, Counted& counted, Context& context,
                 MeshReport& report) {
  if (!options.keep) return;
  auto& [source, stuffing] = counted;
  const Stuffing rest = stuffing.keep(*options.keep, context);
  grade(options.grade, source.frame, stuffing, context);
  report.keep = options.keep_text;
  report.dropped.tets = rest.tet_count();
  report.dropped.pieces = rest.pieces(source.frame, context).whole.by_faces;
  report.dropped.volume = volume_of(rest, source.frame, context);
  if (rest.tet_count() > 0 && stuffing.tet_count() == 0)
    throw Error(ErrorCode::empty_domain,
                fmt::format("none of the {} pieces of '{}' is kept by --keep {}",
                            report.dropped.pieces, report.input_name, report.keep));
}

void count_pieces(const MeshOptions& options, const Counted& counted, Context& context,
                  MeshReport& report) {
  report.pieces = counted.stuffing.pieces(
      output_frame(options, report.axes, counted.source.frame), context);
  report.dropped.kept = report.pieces.whole.by_faces;
}

void measure_distance(const MeshOptions& options, const Source& source, const Counted& counted,
                      const Mesh* moved, Context& context, MeshReport& report) {
  if (!options.distance) return;
  const Stopwatch measuring;
  report.distance = measured_distance(
      source, counted, moved, output_frame(options, report.axes, counted.source.frame), context);
  report.distance_seconds = measuring.seconds();
}

void describe(RegionWatch& watch, const RegionWatch::SizeFor& size_for, MeshReport& report) {
  report.regions = watch.regions(report.tets);
  report.counted_pieces = watch.counted_pieces();
  // What becomes of single labels explains what became of the whole.
  std::vector<std::string> warnings = watch.warnings(!report.dry_run, size_for);
  report.warnings.insert(report.warnings.begin(), std::make_move_iterator(warnings.begin()),
                         std::make_move_iterator(warnings.end()));
}

void describe_materials(const PlacedSource& source, const Context& context,
                        MeshReport& report) {
  report.materials =
      meshed_materials(source, report.names, report.written, report.pieces, context);
  std::vector<std::string> sentences =
      warnings_on(report.materials, report.size, !report.dry_run, report.dropped.pieces > 0);
  report.warnings.insert(report.warnings.begin(), std::make_move_iterator(sentences.begin()),
                         std::make_move_iterator(sentences.end()));
}

MeshReport run(const MeshOptions& asked, Context& context) {
  const Stopwatch clock;
  MeshOptions options = asked;
  MeshReport report;
  report.memory_limit = memory_limit(options);
  limit_memory(report.memory_limit + base_bytes);
  check_outputs(options);
  LabelNames names;
  if (!options.label_names.empty()) names = read_label_names(options.label_names);
  open_size_field(options.grade, report.memory_limit);
  const Source source = open_source(options, report.memory_limit, context);
  names.insert(source.names.begin(), source.names.end());
  report.read_seconds = clock.seconds();
  describe(options, source, report);
  Progress progress(context);
  Counted counted = count(options, source, context, report);
  names.merge(counted.source.domain->names());
  for (const LabelMerge& merge : options.merges)
    if (!merge.name.empty()) names[merge.to] = merge.name;
  report.names = names;
  progress.stop();
  const Stopwatch looking;
  drop_pieces(options, counted, context, report);
  count_pieces(options, counted, context, report);
  report.pieces_seconds = looking.seconds();
  describe(options, counted, progress, report);
  const SizedShape shape = sized(options, source, counted, report.memory_limit);
  if (report.tets == 0) refuse_empty(shape, report.size, options.method, context);
  std::optional<Mesh> moved = optimise(options, counted, context, report);
  keep_sharp(options, counted, moved, context, report);
  const Mesh* const in_memory = moved ? &*moved : nullptr;
  measure_distance(options, source, counted, in_memory, context, report);
  MeshSize size = announce(options, names, counted, in_memory, context, report);
  report.order = add_middle_nodes(options.order, *counted.source.domain, counted.stuffing,
                                  in_memory, size, context);
  const Buffer<Coord3> points = moved ? std::move(moved->points) : Buffer<Coord3>();
  moved.reset();
  if (report.axes) size.space = space(*report.axes);
  report.output_bytes = file_bytes(options.format, size);
  if (size.survey != nullptr) report.warnings = label_losses(options.format, *size.survey);
  const Slabs slabs = plan(counted, size, options.format, report);
  RegionWatch watch(source, counted.source, context);
  if (!options.dry_run)
    write(options, shape, counted, slabs, size, points, context, progress, report);
  watch.see(report.written.regions);
  watch.see(report.pieces,
            report.pieces.regions.empty() ? report.written.region_pieces : report.pieces.regions,
            report.dropped.pieces > 0);
  const auto size_for = [&](std::span<const ImageRegion> regions) {
    return size_for_pieces(shape, *source.voxels, regions, report, context);
  };
  describe(watch, size_for, report);
  if (report.features.figures && !report.features.figures->all_followed())
    report.warnings.push_back(sentence_on(*report.features.figures));
  if (!options.materials.empty()) describe_materials(counted.source, context, report);
  report.total_seconds = clock.seconds();
  report.memory_peak = peak_memory();
  return report;
}

}  // namespace

Run declare_mesh(CLI::App& app) {
  return [options = declare_mesh_options(app),
          carry_out = run_and_tell<MeshOptions, MeshReport>(run)] { return carry_out(options()); };
}

}  // namespace certet::command
