#include "mesh_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>

#include "certet/surface.hpp"
#include "certet/volume.hpp"
#include "format_choice.hpp"
#include "mesh_notes.hpp"
#include "method.hpp"
#include "option_values.hpp"
#include "patch_options.hpp"
#include "refusal.hpp"
#include "shared_options.hpp"
#include "surface_choice.hpp"

namespace certet::command {
namespace {

/// Options whose values need more than CLI11's own reading.
struct RawMesh {
  std::string volume, nan, size, relative_size, target_tets, iso, labels, spacing, smooth, crop,
      bounds, format, origin, keep, frame, scale, merge;
  std::vector<std::filesystem::path> inputs;
  RawMaterials materials;
  std::vector<std::string> patches;
  MethodChoice method;
  std::string optimise_to, features;
  RawGrade grade;
  bool compress = false;
};

void declare_source(CLI::App& mesh, MeshOptions& options, RawMesh& raw) {
  mesh.add_option("input", raw.inputs,
                  "Image: NIfTI, NRRD, MetaImage, TIFF, a folder with a DICOM series, a DICOM "
                  "file of several frames or a DICOM segmentation; "
                  "surface: STL, OBJ, PLY or OFF; volume: OpenVDB.  Several files are one material "
                  "each, called after the files; labels of an image are so each for itself")
      ->option_text("INPUT...");
  declare_materials(mesh, raw.materials);
  mesh.add_option("--labels", raw.labels,
                  "Labels that make the solid, like 1,5-9 (default: all but 0)")
      ->option_text("LIST");
  mesh.add_option("--merge", raw.merge,
                  "Makes one of several labels before any are chosen, like 1-5=bone,7=9; @FILE has "
                  "one on each line")
      ->option_text("LIST|@FILE");
  mesh.add_option("--iso", raw.iso,
                  "The solid is where the image is above V, between two values (A..B) or below "
                  "one (..B)")
      ->option_text("V|A..B");
  mesh.add_option("--spacing", raw.spacing,
                  "Size of a voxel, in the place of what the image's file says")
      ->option_text("a,b,c");
  mesh.add_option("--smooth", raw.smooth,
                  "How smooth the surfaces of labels are: the standard deviation of a Gaussian, "
                  "in world units (default: one voxel; with --method paper 0); 0: they follow "
                  "the faces of voxels")
      ->option_text("SIGMA");
  mesh.add_option("--crop", raw.crop,
                  "Box in world coordinates; of an image's solid, only what is in it is meshed")
      ->option_text("x0,y0,z0,x1,y1,z1");
  mesh.add_option("--series", options.image.series,
                  "UID of the DICOM series, where a folder holds several")
      ->option_text("UID");
  mesh.add_option("--volume", raw.volume,
                  "Which of several volumes in an image's file, or of several numbers per "
                  "voxel, counted from 0")
      ->option_text("N");
  mesh.add_option("--nan", raw.nan,
                  "What voxels that are NaN are read as: a label or, with --iso, a value")
      ->option_text("V");
  mesh.add_option("--grid", options.grid, "Grid of a .vdb file (default: its first level set)")
      ->option_text("NAME");
  mesh.add_flag("--repair", options.repair,
                "Closes the holes of an open surface by the generalised winding number; without "
                "it, such a surface is refused");
  mesh.add_option("--expr", options.formula,
                  "The solid is where a formula in x, y, z is negative; @FILE holds one")
      ->option_text("FORMULA|@FILE");
  mesh.add_option("--shape", options.shape, "A named shape, like torus:1,0.4; see below")
      ->option_text("NAME:NUMBERS");
  mesh.add_option("--bounds", raw.bounds,
                  "Box that cuts off the solid of a formula, or of a shape (optional)")
      ->option_text("x0,y0,z0,x1,y1,z1");
}

void declare_lattice(CLI::App& mesh, MeshOptions& options, RawMesh& raw) {
  mesh.add_option("--size", raw.size,
                  "Long edge in world units (default: the smallest voxel spacing; "
                  "without an image a 64th of the longest side, or for a thin surface less)")
      ->option_text("H");
  mesh.add_option("--rel-size", raw.relative_size,
                  "Long edge as a fraction of the longest side of the solid's box: of the "
                  "voxels chosen (along the image's axes), of --bounds, or of the shape")
      ->option_text("F");
  mesh.add_option("--target-tets", raw.target_tets,
                  "Finds the size that gives about N tetrahedra: within 2 % of N, or the "
                  "nearest of 12 tries")
      ->option_text("N");
  mesh.add_option("--margin", options.margin, "Lattice cells around the solid (default: 2)")
      ->check(CLI::Range(1, 1000))
      ->option_text("N");
  declare_method(mesh, raw.method);
  declare_grade(mesh, options.grade, raw.grade);
  mesh.add_option("--keep", raw.keep,
                  "Drops all pieces but the largest, the N largest, or those that go through "
                  "from end to end: largest, N, percolating:x (y, z)")
      ->option_text("WHICH");
  mesh.add_flag("--distance", options.distance,
                "Measures how far the surface of the mesh is from that of the shape, and back");
  mesh.add_flag("--label-pieces", options.label_pieces,
                "With --method paper: counts the pieces of each label in the mesh, too");
}

void declare_placing(CLI::App& mesh, std::string& frame, std::string& scale) {
  mesh.add_option("--frame", frame,
                  "Axes of the output, of an image that tells its own: lps (to the left, the back, "
                  "the head; default), ras (right, front, head) or those of the input's file")
      ->check(CLI::IsMember({"lps", "ras", "input"}))
      ->option_text("lps|ras|input");
  mesh.add_option("--scale", scale,
                  "Factor of all coordinates that go out, like 0.001 from mm to m")
      ->option_text("S");
}

void declare_run(CLI::App& mesh, MeshOptions& options, RawMesh& raw) {
  declare_output(mesh, "-o,--output", options.output);
  declare_format(mesh, raw.format, raw.compress);
  declare_origin(mesh, raw.origin,
                 "they are relative to the lattice's origin, which lies at the solid and is told in "
                 "table and JSON");
  declare_order(mesh, options.order);
  declare_optimise(mesh, options.optimise, raw.optimise_to);
  declare_features(mesh, raw.features);
  declare_placing(mesh, raw.frame, raw.scale);
  declare_label_names(mesh, options.label_names);
  declare_surface_choice(mesh, options.surface);
  mesh.add_option("--patch", raw.patches,
                  "Names a patch of the boundary, like inlet=xmin (a side where bounds or the "
                  "image's edge cut the shape off; or surface) or top=z:12.5 (what lies at a plane, "
                  "within half a long edge); may be repeated")
      ->option_text("NAME=SIDE|AXIS:AT")
      ->take_all();
  declare_threads(mesh, options.run);
  mesh.add_option("--max-memory", options.max_memory,
                  "Memory to use, like 800M or 4G (default: three quarters of what is free)")
      ->transform(CLI::AsSizeValue(false))
      ->option_text("BYTES");
  mesh.add_flag("--dry-run", options.dry_run, "Count, but write nothing");
  declare_json(mesh, options.run);
}

/// All solids that the options name.
std::vector<SolidChoice> solids_of(const MeshOptions& options) {
  std::vector<SolidChoice> solids;
  for (const MaterialChoice& material : options.materials) solids.push_back(material.solid);
  if (options.materials.empty())
    solids.push_back({options.input, options.formula, options.shape});
  solids.insert(solids.end(), options.inside.begin(), options.inside.end());
  solids.insert(solids.end(), options.without.begin(), options.without.end());
  return solids;
}

/// What goes with several solids.
void check_solids(const MeshOptions& options, const RawMesh& raw) {
  const std::vector<SolidChoice> solids = solids_of(options);
  const auto any = [&](const auto& is_so) { return std::ranges::any_of(solids, is_so); };
  const bool formula = any([](const SolidChoice& s) { return !s.formula.empty(); });
  const bool shape = any([](const SolidChoice& s) { return !s.shape.empty(); });
  const bool surface = any([](const SolidChoice& s) { return is_surface_file(s.file); });
  const bool volume = any([](const SolidChoice& s) { return is_volume_file(s.file); });
  const bool image = any([](const SolidChoice& s) { return s.is_image(); });
  if (formula && raw.bounds.empty() &&
      std::ranges::all_of(options.inside, [](const SolidChoice& s) { return !s.formula.empty(); }))
    refuse("a formula in --expr, --material, --inside or --subtract needs --bounds, or something "
           "else in --inside");
  if (!formula && !shape && !raw.bounds.empty()) refuse("--bounds goes with formulas and shapes");
  if (!volume && !options.grid.empty())
    refuse("--grid goes with a volume, of which there is none among the solids");
  if (!volume && !image && !raw.iso.empty())
    refuse("--iso goes with an image or a volume, of which there is none among the solids");
  if (volume && raw.iso.find("..") != raw.iso.npos) refuse("--iso takes one value with a .vdb file");
  if (!surface && options.repair)
    refuse("--repair goes with a surface, of which there is none among the solids");
  if (!image && !(raw.labels.empty() && raw.spacing.empty() && options.image.series.empty() &&
                  raw.volume.empty() && raw.nan.empty() && raw.smooth.empty() &&
                  raw.merge.empty() && raw.frame.empty() && options.label_names.empty()))
    refuse("--labels, --label-names, --merge, --spacing, --series, --volume, --nan, --smooth and "
           "--frame go with an image, of which there is none among the solids");
  if (!raw.iso.empty() && !(raw.labels.empty() && raw.smooth.empty() && raw.merge.empty()))
    refuse("--labels, --merge and --smooth go with labels, not with --iso");
  if (!raw.crop.empty() && !(options.materials.empty() && solids.front().is_image()))
    refuse("--crop goes with a single image; --inside is for all that is meshed");
}

void check_source(const MeshOptions& options, const RawMesh& raw) {
  const bool image = !options.input.empty();
  const bool formula = !options.formula.empty();
  const bool shape = !options.shape.empty();
  const bool materials = !options.materials.empty();
  if (image + formula + shape + materials == 0)
    refuse("mesh needs an input, --expr, --shape or --material");
  if (materials && formula + shape > 0)
    refuse("several materials exclude --expr and --shape; --material NAME=... has formulas and "
           "shapes");
  if (image + formula + shape > 1) refuse("an input, --expr and --shape exclude each other");
  if (materials || !options.inside.empty() || !options.without.empty())
    return check_solids(options, raw);
  if (!image && (!raw.labels.empty() || !raw.iso.empty()))
    refuse("--labels and --iso go with an image, not with --expr or --shape");
  if (formula && raw.bounds.empty()) refuse("--expr needs --bounds");
  if (image && !raw.bounds.empty()) refuse("--bounds goes with --expr and --shape");
  if (!options.grid.empty() && !is_volume_file(options.input))
    refuse("--grid goes with a .vdb file");
  if (is_surface_file(options.input) && (!raw.labels.empty() || !raw.iso.empty()))
    refuse("--labels and --iso go with an image or a volume, not with a surface");
  if (options.repair && !is_surface_file(options.input))
    refuse("--repair goes with a surface: STL, OBJ, PLY or OFF");
  if (is_volume_file(options.input) && !raw.labels.empty())
    refuse("--labels goes with an image, not with a volume");
  if (!options.label_names.empty() && (!image || !raw.iso.empty()))
    refuse("--label-names goes with an image of labels");
  if (options.label_pieces && (!image || !raw.iso.empty()))
    refuse("--label-pieces goes with an image of labels");
  const bool voxels =
      image && !is_surface_file(options.input) && !is_volume_file(options.input);
  if (!voxels && (!raw.spacing.empty() || !options.image.series.empty()))
    refuse("--spacing and --series go with an image");
  if (!voxels && (!raw.volume.empty() || !raw.nan.empty()))
    refuse("--volume and --nan go with an image");
  if (!voxels && (!raw.smooth.empty() || !raw.crop.empty()))
    refuse("--smooth and --crop go with an image");
  if (!voxels && !raw.frame.empty()) refuse("--frame goes with an image");
  if (!raw.smooth.empty() && !raw.iso.empty())
    refuse("--smooth goes with labels, not with --iso");
  if (!raw.labels.empty() && !raw.iso.empty())
    refuse("--labels and --iso exclude each other");
  if (!raw.merge.empty() && (!voxels || !raw.iso.empty()))
    refuse("--merge goes with an image of labels");
}

void read_size(MeshOptions& options, const RawMesh& raw) {
  if (!raw.size.empty() + !raw.relative_size.empty() + !raw.target_tets.empty() > 1)
    refuse("--size, --rel-size and --target-tets exclude each other");
  if (!raw.size.empty()) options.size = parse_positive("--size", raw.size);
  if (!raw.relative_size.empty())
    options.relative_size = parse_positive("--rel-size", raw.relative_size);
  if (!raw.target_tets.empty()) options.target_tets = parse_count("--target-tets", raw.target_tets);
}

/// A value or, for labels, a whole number of 32 bits.
double parse_nan(const MeshOptions& options, const std::string& text) {
  const double value = parse_number("--nan", text);
  if (!options.iso && (value != std::floor(value) || std::fabs(value) > 2147483647))
    refuse("--nan takes a label, not '" + text + "', unless there is --iso");
  return value;
}

double parse_smooth(const std::string& text) {
  const double value = parse_number("--smooth", text);
  if (value < 0) refuse("--smooth takes a positive number or 0, not '" + text + "'");
  return value;
}

void read_iso(MeshOptions& options, const std::string& text) {
  const LevelRange range = parse_levels(text);
  options.iso = range.above;
  options.below = range.below;
  if (options.below && is_volume_file(options.input))
    refuse("--iso takes one value with a .vdb file");
}

MeshOptions finish(MeshOptions options, const RawMesh& raw) {
  options.materials = chosen_materials(raw.inputs, raw.materials);
  options.priority = chosen_priority(options.materials, raw.materials);
  options.inside = chosen_solids(raw.materials.inside);
  options.without = chosen_solids(raw.materials.without);
  if (options.materials.empty() && !raw.inputs.empty()) options.input = raw.inputs.front();
  check_source(options, raw);
  read_size(options, raw);
  options.method = chosen(raw.method);
  if (!raw.iso.empty()) read_iso(options, raw.iso);
  if (raw.merge.starts_with('@')) options.merges = read_merges(raw.merge.substr(1));
  else if (!raw.merge.empty()) options.merges = parse_merges(raw.merge);
  if (!raw.labels.empty()) options.labels = parse_labels(raw.labels);
  if (!raw.smooth.empty()) options.smooth = parse_smooth(raw.smooth);
  if (!raw.crop.empty()) options.crop = parse_bounds(raw.crop, "--crop");
  if (!raw.volume.empty()) options.image.volume = parse_whole("--volume", raw.volume);
  if (!raw.nan.empty()) options.nan = parse_nan(options, raw.nan);
  if (!raw.spacing.empty()) options.image.spacing = parse_spacing(raw.spacing);
  if (!raw.bounds.empty()) options.bounds = parse_bounds(raw.bounds);
  if (!raw.keep.empty()) options.keep = parse_keep(options.keep_text = raw.keep);
  if (options.output.empty() && !options.dry_run) refuse("mesh needs an output: -o OUT");
  options.format = choose_format(options.output, raw.format, raw.compress);
  check_surface_choice(options.surface, options.format);
  options.patches = chosen_patches(raw.patches, options.format);
  check_order(options.order, options.format, options.method);
  check_optimise(options.optimise, raw.optimise_to, options.method);
  options.features = chosen_features(raw.features, options.method);
  check_grade(options.grade, raw.grade,
              options.optimise.wanted || (!options.features.automatic && options.features.angle));
  if (raw.origin == "0") options.origin = OutputOrigin::lattice;
  if (raw.frame == "lps") options.frame = OutputFrame::lps;
  if (raw.frame == "ras") options.frame = OutputFrame::ras;
  if (raw.frame == "input") options.frame = OutputFrame::input;
  if (!raw.scale.empty()) options.scale = parse_positive("--scale", raw.scale);
  return options;
}

}  // namespace

std::function<MeshOptions()> declare_mesh_options(CLI::App& mesh) {
  const auto options = std::make_shared<MeshOptions>();
  const auto raw = std::make_shared<RawMesh>();
  declare_source(mesh, *options, *raw);
  declare_lattice(mesh, *options, *raw);
  declare_run(mesh, *options, *raw);
  mesh.footer(mesh_notes);
  return [options, raw] { return finish(*options, *raw); };
}

}  // namespace certet::command
