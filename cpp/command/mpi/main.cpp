// The program `certet-mpi`: one mesh by all processes of `mpirun`.

#include <array>
#include <cstdio>

#include "command_line.hpp"
#include "ending.hpp"
#include "failure.hpp"
#include "mesh/together.hpp"
#include "mpi_file.hpp"
#include "mpi_ranks.hpp"
#include "signals.hpp"

namespace certet::command {
namespace {

Status run(int argc, char** argv, MpiRanks& ranks) {
  const Together together{ranks, ranks.on_this_machine(),
                          [&ranks](const std::filesystem::path& file, std::uint64_t bytes) {
                            return create_shared(file, bytes, ranks);
                          }};
  const std::array commands{
      Subcommand{"mesh", "Mesh an image, a surface, a volume, a formula or a shape together",
                 [&together](CLI::App& app) { return declare_shared_mesh(app, together); }}};
  const Status status = CommandLine("certet-mpi", commands).parse(argc, argv)();
  meet(ranks);
  return status;
}

/// Of all processes the first one speaks for all.
Status run_or_tell(int argc, char** argv, MpiRanks& ranks) {
  if (ranks.rank() != 0 && std::freopen("/dev/null", "w", stdout) == nullptr)
    std::fclose(stdout);
  try {
    return run(argc, argv, ranks);
  } catch (...) {
    const Failure failure = ranks.first_failure(current_failure());
    if (ranks.rank() == 0) std::fprintf(stderr, "certet-mpi: %s\n", failure.sentence.c_str());
    return failure.status;
  }
}

}  // namespace
}  // namespace certet::command

int main(int argc, char** argv) {
  using namespace certet::command;
  ignore_write_signals();
  const MpiSession session(argc, argv);
  end_at_signals();
  MpiRanks ranks;
  return static_cast<int>(run_or_tell(argc, argv, ranks));
}
