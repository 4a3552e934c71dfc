#include <CLI/CLI.hpp>
#include <memory>

#include "certet/error.hpp"
#include "certet/formats.hpp"
#include "check_report.hpp"
#include "commands.hpp"
#include "memory.hpp"
#include "outputs.hpp"
#include "signals.hpp"
#include "stopwatch.hpp"

namespace certet::command {
namespace {

constexpr const char* footer = R"(
Keys of the JSON: certet, command, file, ok, failures, mesh {points, tets, volume, checksum,
unused_points, nonfinite_points, duplicate_points, bad_indices, nonpositive_tets,
overfull_faces, misoriented_faces, boundary_faces, open_edges}, dihedral {min, max,
histogram}, seconds {read, check, total}, memory {peak}.)";

/// What the user asks of `certet check`.
struct CheckOptions {
  std::filesystem::path mesh;
  std::string json;
  int threads = 0;
};

Status check(const CheckOptions& options) {
  const Stopwatch clock;
  Context context;
  context.threads = options.threads;
  const Signals signals(context);
  if (!options.json.empty() && options.json != "-") {
    if (same_file(options.mesh, options.json))
      throw Error(ErrorCode::bad_option, "the mesh and --json are the same file '" +
                                             options.mesh.string() + "'");
    judge_output(options.json);
  }
  CheckedFile checked;
  checked.file = options.mesh.string();
  const FileMesh mesh = read_mesh(options.mesh, context);
  checked.read_seconds = clock.seconds();
  checked.report = certet::check(mesh.points, std::span<const Tet<std::uint64_t>>(mesh.tets),
                                context);
  checked.checksum = checksum(mesh);
  checked.total_seconds = clock.seconds();
  checked.check_seconds = checked.total_seconds - checked.read_seconds;
  checked.memory_peak = peak_memory();
  tell(checked, options.json);
  return checked.report.failures.empty() ? Status::ok : Status::check_failed;
}

}  // namespace

Run declare_check(CLI::App& app) {
  const auto options = std::make_shared<CheckOptions>();
  app.add_option("mesh", options->mesh, "Mesh: .vtu, .mesh, .meshb or .msh")
      ->required()->option_text("MESH");
  app.add_option("--threads", options->threads, "Threads (default: as many as there are)")
      ->check(CLI::Range(0, 1024))
      ->option_text("N");
  app.add_option("--json", options->json, "Report for programs; - is stdout")
      ->option_text("FILE|-");
  app.footer(footer);
  return [options] { return check(*options); };
}

}  // namespace certet::command
