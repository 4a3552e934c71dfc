#include <CLI/CLI.hpp>
#include <memory>

#include "certet/error.hpp"
#include "certet/formats.hpp"
#include "certet/label_names.hpp"
#include "commands.hpp"
#include "format_choice.hpp"
#include "json.hpp"
#include "option_values.hpp"
#include "outputs.hpp"
#include "shared_options.hpp"
#include "stopwatch.hpp"
#include "surface_choice.hpp"
#include "table.hpp"
#include "told_run.hpp"

namespace certet::command {
namespace {

constexpr const char* convert_notes = R"(
Labels are kept, and their names and the patches of the boundary where the formats
have them (.vtu has neither; .mesh and .meshb have numbers, of which those of sides are known, and
other patches are called patch_9, patch_10, ...); the boundary is found anew, and so are the interfaces, where
two labels touch, which go out beside it.  Groups of .msh have positive numbers: other labels
have the next that are free there, which a warning tells, and a comment in the file, by which
they are read back.

All formats but .stl have coordinates of double precision.  A boundary that single
precision cannot hold is not written (status 6): where points would fall together, or
triangles lose their area or turn by more than 4.5 degrees.

Keys of the JSON: certet, command, input, output {file, format, bytes, origin, scale}, mesh
{points, tets, middle_nodes (where tetrahedra have ten nodes), regions, boundary_faces, interfaces, interface_faces, checksum}, seconds,
warnings.)";

/// What the user asks of `certet convert`.
struct ConvertOptions {
  std::filesystem::path input, output, label_names;
  std::string format, origin, surface, scale;
  bool compress = false;
  RunOptions run;
};

/// What is known at the end.
struct ConvertReport {
  std::string input, output, format;
  std::uint64_t middle_nodes = 0;  ///< of tetrahedra of ten nodes
  std::uint64_t bytes = 0, points = 0, tets = 0, regions = 0, boundary_faces = 0, interfaces = 0, interface_faces = 0,
                checksum = 0;
  Point3 output_origin{};  ///< in the input: where the coordinates of the output have their 0
  double scale = 1;
  std::vector<std::string> warnings = {};
  double seconds = 0;
};

std::string table(const ConvertReport& report) {
  Lines lines;
  lines.add("input", "{}", report.input);
  lines.add("output", "{} ({}, {})", report.output, report.format, bytes(report.bytes));
  if (report.output_origin != Point3{})
    lines.add("origin", "0 in the output is ({:.17g}, {:.17g}, {:.17g}) in the input",
              report.output_origin[0], report.output_origin[1], report.output_origin[2]);
  if (report.scale != 1) lines.add("scale", "{:.9g}, of all coordinates", report.scale);
  lines.add("mesh", "{} points, {} tetrahedra, {} regions, {} boundary faces",
            grouped(report.points), grouped(report.tets), grouped(report.regions),
            grouped(report.boundary_faces));
  if (report.middle_nodes > 0)
    lines.add("order", "2: {} middle nodes", grouped(report.middle_nodes));
  if (report.interfaces > 0)
    lines.add("", "{} interfaces of {} triangles", grouped(report.interfaces),
              grouped(report.interface_faces));
  for (const std::string& warning : report.warnings) lines.add("warning", "{}", warning);
  lines.add("checksum", "0x{:016x}", report.checksum);
  lines.add("seconds", "{:.2f}", report.seconds);
  return std::move(lines).text();
}

std::string json(const ConvertReport& report) {
  Json json = json_of_command("convert");
  json["input"] = report.input;
  json["output"] = {
      {"file", report.output}, {"format", report.format}, {"bytes", report.bytes},
      {"origin", report.output_origin}, {"scale", report.scale}};
  json["mesh"] = {{"points", report.points},
                  {"tets", report.tets},
                  {"regions", report.regions},
                  {"boundary_faces", report.boundary_faces},
                  {"interfaces", report.interfaces},
                  {"interface_faces", report.interface_faces},
                  {"checksum", fmt::format("0x{:016x}", report.checksum)}};
  if (report.middle_nodes > 0) json["mesh"]["middle_nodes"] = report.middle_nodes;
  json["seconds"] = report.seconds;
  json["warnings"] = report.warnings;
  return print(json);
}

void check_files(const ConvertOptions& options, Format format) {
  const bool json_file = options.run.has_json_file();
  for (const std::filesystem::path& file : files_of(options.output, format)) {
    if (same_file(options.input, file))
      throw Error(ErrorCode::bad_option,
                  "input and output are the same file '" + options.input.string() + "'");
    if (json_file && same_file(file, options.run.json))
      throw Error(ErrorCode::bad_option,
                  "output and --json are the same file '" + file.string() + "'");
  }
  check_mesh_output(options.output, format);
  if (!json_file) return;
  if (same_file(options.input, options.run.json))
    throw Error(ErrorCode::bad_option,
                "input and --json are the same file '" + options.input.string() + "'");
  check_output(options.run.json);
}

/// A writer would say the same, but with no word of the input.
void check_indices(const ConvertOptions& options, const FileMesh& mesh) {
  for (const Tet<std::uint64_t>& tet : mesh.tets)
    for (const std::uint64_t point : tet)
      if (point >= mesh.points.size())
        throw Error(ErrorCode::bad_input,
                    "cannot convert '" + options.input.string() +
                        "': a tetrahedron names a point that is not there");
}

void write(const ConvertOptions& options, Format format, const FileMesh& mesh,
           const MeshSize& size, std::span<const Point3> middle_points,
           const Context& context) {
  const auto writer = open_writer(options.output, format, size);
  writer->points(mesh.points);
  writer->points(middle_points);
  constexpr std::size_t piece = 1 << 20;
  const std::span<const std::int32_t> labels(mesh.labels);
  for (std::size_t begin = 0; begin < mesh.tets.size(); begin += piece) {
    stop_if_cancelled(context);
    const std::size_t count = std::min(piece, mesh.tets.size() - begin);
    writer->tets(std::span(mesh.tets).subspan(begin, count),
                 labels.empty() ? labels : labels.subspan(begin, count));
  }
  stop_if_cancelled(context);
  writer->finish();
}

ConvertReport run(const ConvertOptions& options, Context& context) {
  const Stopwatch clock;
  const Format format = choose_format(options.output, options.format, options.compress);
  check_surface_choice(options.surface, format);
  check_files(options, format);
  FileMesh mesh = certet::read(options.input, context);
  check_indices(options, mesh);
  const double factor = options.scale.empty() ? 1 : parse_positive("--scale", options.scale);
  const Point3 moved_to = options.origin == "0" ? move_to_zero(mesh) : Point3{};
  scale(mesh, factor);
  if (!options.label_names.empty()) mesh.names = read_label_names(options.label_names);
  const auto found = std::make_shared<Survey>(survey(mesh, context));
  const std::uint64_t boundary_faces = found->boundary.size();
  const std::uint64_t interfaces = found->interfaces.size(), faces = face_count(*found);
  choose_surface(options.surface, mesh.names, *found);
  stop_if_cancelled(context);
  const FileMiddleNodes nodes = file_middle_nodes(mesh, options.output);
  const MeshSize size{mesh.points.size() + nodes.points.size(), mesh.tets.size(),
                      !mesh.labels.empty(), found, mesh.space, nodes.middles};
  write(options, format, mesh, size, nodes.points, context);
  ConvertReport report{options.input.string(), options.output.string(), std::string(name(format))};
  for (const std::filesystem::path& file : files_of(options.output, format))
    report.bytes += std::filesystem::file_size(file);
  report.points = mesh.points.size();
  report.middle_nodes = nodes.points.size();
  report.tets = mesh.tets.size();
  report.regions = found->regions.size();
  report.boundary_faces = boundary_faces;
  report.interfaces = interfaces;
  report.interface_faces = faces - boundary_faces;
  report.checksum = checksum(mesh);
  report.output_origin = moved_to;
  report.scale = factor;
  report.warnings = label_losses(format, *found);
  report.seconds = clock.seconds();
  return report;
}

void declare(CLI::App& app, ConvertOptions& options) {
  declare_mesh_file(app, "input", "IN", options.input);
  declare_output(app, "output", options.output)->required();
  declare_format(app, options.format, options.compress);
  declare_origin(app, options.origin,
                 "a mesh that is farther from 0 than it is long is moved there, exactly, which "
                 "table and JSON tell");
  app.add_option("--scale", options.scale,
                 "Factor of all coordinates, like 0.001 from mm to m (after --origin)")
      ->option_text("S");
  declare_label_names(app, options.label_names);
  declare_surface_choice(app, options.surface);
  declare_json(app, options.run);
}

}  // namespace

Run declare_convert(CLI::App& app) {
  return subcommand<ConvertOptions>(app, declare, convert_notes,
                                    run_and_tell<ConvertOptions, ConvertReport>(run));
}

}  // namespace certet::command
