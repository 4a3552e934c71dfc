#include <CLI/CLI.hpp>
#include <utility>

#include "certet/formats.hpp"
#include "commands.hpp"
#include "option_values.hpp"
#include "outputs.hpp"
#include "refusal.hpp"
#include "shared_options.hpp"
#include "silence.hpp"
#include "stopwatch.hpp"
#include "told_run.hpp"
#include "voxelise_report.hpp"

namespace certet::command {
namespace {

constexpr const char* voxelise_notes = R"(
Each voxel has the label of the tetrahedron that holds its centre, 0 where none does; a mesh
without labels has label 1.  Points are rounded to 2^-20 voxels, from there on all is exact: a
centre on a face, edge or corner belongs to where a step along the first axis leads or, if that
stays on it, along the second, or the third.  So each centre in a mesh is in one tetrahedron and
no other.

Coordinates of images are LPS, of NIfTI too, as `certet mesh` writes them unless told otherwise;
a .vtu file that says RAS is understood, --frame ras tells it of others.

--compare shows how a label image came through a mesh: Dice is twice the voxels that have a label
in both, over the sum of those that have it in either.

Keys of the JSON: certet, command, input, output {file, bytes}, grid {size, spacing, origin,
axes}, mesh {tets, flat_tets}, voxels {held, held_twice}, labels [{label, name, voxels, and
compared: image_voxels, both, dice}], compared {file, mean_dice, least_dice}, seconds,
warnings.)";

/// What the user asks of `certet voxelise`.
struct VoxeliseOptions {
  std::filesystem::path mesh, output, like, compare;
  std::string spacing, frame;
  RunOptions run;
};

void check_options(const VoxeliseOptions& options) {
  if (options.output.empty() && options.compare.empty())
    refuse("voxelise needs an output, -o LABELS, or --compare IMAGE");
  if (!options.like.empty() && !options.spacing.empty())
    refuse("--like and --spacing exclude each other");
  if (options.like.empty() && options.spacing.empty() && options.compare.empty())
    refuse("voxelise needs --like IMAGE or --spacing a,b,c");
  if (!options.spacing.empty() && !options.compare.empty())
    refuse("--spacing and --compare exclude each other: images are compared voxel by voxel");
  const bool json_file = options.run.has_json_file();
  for (const std::filesystem::path& input : {options.mesh, options.like, options.compare}) {
    if (input.empty()) continue;
    if (!options.output.empty() && same_file(input, options.output))
      refuse("the output would replace the input '" + input.string() + "'");
    if (json_file && same_file(input, options.run.json))
      refuse("--json would replace the input '" + input.string() + "'");
  }
  if (!options.output.empty()) {
    check_labels_file(options.output);
    check_output(options.output);
  }
  if (json_file && !options.output.empty() && same_file(options.output, options.run.json))
    refuse("output and --json are the same file '" + options.run.json + "'");
  if (json_file) check_output(options.run.json);
}

Image image_of(const std::filesystem::path& file) {
  const Silence silence;
  return read_image(file);
}

void write_to(const std::filesystem::path& file, const Image& labels) {
  const Silence silence;
  write_labels(labels, file);
}

/// As images are: LPS.
FileMesh read_mesh(const VoxeliseOptions& options, const Context& context) {
  FileMesh mesh = certet::read(options.mesh, context);
  if (options.frame == "ras" || (options.frame.empty() && mesh.space == "RAS"))
    for (Point3& point : mesh.points) {
      point[0] = -point[0];
      point[1] = -point[1];
    }
  return mesh;
}

/// With the image that was asked for or, for the numbers of voxels, with itself.
std::vector<LabelOverlap> compared(const VoxeliseOptions& options, const Image& made,
                                   const Image& other) {
  return options.compare.empty() ? compare_labels(made, made) : compare_labels(made, other);
}

VoxeliseReport run(const VoxeliseOptions& options, Context& context) {
  const Stopwatch clock;
  check_options(options);
  Image other;
  if (!options.compare.empty()) other = image_of(options.compare);
  const FileMesh mesh = read_mesh(options, context);
  Image grid;
  if (!options.like.empty()) grid = place_of(image_of(options.like));
  else if (!options.spacing.empty()) grid = grid_around(mesh, parse_spacing(options.spacing));
  else grid = place_of(other);
  VoxeliseReport report;
  report.input = options.mesh.string();
  report.output = options.output.string();
  report.tets = mesh.tets.size();
  report.made = voxelise(mesh, std::move(grid), context);
  report.made.image.name = options.mesh.string();
  report.compared = options.compare.string();
  report.overlaps = compared(options, report.made.image, other);
  report.names = mesh.names;
  report.names.insert(other.names.begin(), other.names.end());
  report.warnings = warnings_on_voxels(report.made);
  stop_if_cancelled(context);
  if (!options.output.empty()) {
    write_to(options.output, report.made.image);
    report.bytes = std::filesystem::file_size(options.output);
  }
  report.seconds = clock.seconds();
  return report;
}

void declare(CLI::App& app, VoxeliseOptions& options) {
  declare_mesh_file(app, "mesh", "MESH", options.mesh);
  app.add_option("-o,--output", options.output, "Image of labels: .nrrd, .mha, .nii or .nii.gz")
      ->option_text("LABELS");
  app.add_option("--like", options.like, "Voxels lie as in this image (default: as in that of --compare)")
      ->option_text("IMAGE");
  app.add_option("--spacing", options.spacing, "Size of a voxel, of a grid that lies around the mesh")
      ->option_text("a,b,c");
  app.add_option("--compare", options.compare,
                 "Image of labels that the voxels are compared with, label by label")
      ->option_text("IMAGE");
  app.add_option("--frame", options.frame,
                 "Which way the mesh's axes go, as --frame of `certet mesh` (default: what the file "
                 "says, else lps)")
      ->check(CLI::IsMember({"lps", "ras"}))
      ->option_text("lps|ras");
  declare_run(app, options.run);
}

}  // namespace

Run declare_voxelise(CLI::App& app) {
  return subcommand<VoxeliseOptions>(app, declare, voxelise_notes,
                                     run_and_tell<VoxeliseOptions, VoxeliseReport>(run));
}

}  // namespace certet::command
