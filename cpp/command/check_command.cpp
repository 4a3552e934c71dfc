#include "certet/check.hpp"

#include "certet/error.hpp"
#include "certet/formats.hpp"
#include "commands.hpp"
#include "memory.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "report.hpp"

namespace certet::command {

Status check(const CheckOptions& options) {
  const Stopwatch clock;
  if (!options.json.empty() && options.json != "-") {
    if (same_file(options.mesh, options.json))
      throw Error(ErrorCode::bad_option, "the mesh and --json are the same file '" +
                                             options.mesh.string() + "'");
    judge_output(options.json);
  }
  CheckedFile checked;
  checked.file = options.mesh.string();
  const FileMesh mesh = read_mesh(options.mesh);
  checked.read_seconds = clock.seconds();
  checked.report = certet::check(mesh.points, std::span<const Tet<std::uint64_t>>(mesh.tets));
  checked.total_seconds = clock.seconds();
  checked.check_seconds = checked.total_seconds - checked.read_seconds;
  checked.memory_peak = peak_memory();
  tell(checked, options.json);
  return checked.report.failures.empty() ? Status::ok : Status::check_failed;
}

}  // namespace certet::command
