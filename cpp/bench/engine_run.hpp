#pragma once
/// \file
/// The engine run again and again, and the best of it kept.

#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "certet/stuffing.hpp"
#include "stage_clock.hpp"

namespace certet::bench {

/// The numbers that a finished mesh consists of.
inline std::uint64_t mesh_bytes(const Mesh& mesh) {
  return std::visit(
      [&](const auto& tets) {
        return mesh.points.size() * sizeof(Coord3) + tets.size() * sizeof(tets[0]);
      },
      mesh.tets);
}

/// The most memory that this process has held so far, in bytes; 0 where the
/// system does not tell.  `getrusage` would count what the process that started
/// this one held.
inline std::uint64_t peak_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stoull(line.substr(6)) * 1024;
  return 0;
}

/// One case of a benchmark: a domain, meshed by a number of threads.
class EngineRun {
 public:
  explicit EngineRun(int threads) : clock_(context_) { context_.threads = threads; }

  /// Meshes once, everything from sampling to the mesh in memory.
  Mesh run(const Domain& domain, const Lattice& lattice, Method method) {
    clock_.start();
    const double start = now();
    Mesh mesh = stuff(domain, lattice, {}, method, context_);
    const double seconds = now() - start;
    const StageSeconds& stages = clock_.stop();
    if (seconds < best_) {
      best_ = seconds;
      stages_ = stages;
    }
    return mesh;
  }

  /// The least time of all runs, and what it was made of, in seconds.
  [[nodiscard]] nlohmann::json report(const Mesh& mesh) const {
    nlohmann::json json{{"threads", context_.threads},
                        {"tets", mesh.tet_count()},
                        {"points", mesh.points.size()},
                        {"mesh_bytes", mesh_bytes(mesh)},
                        {"seconds", best_}};
    for (int s = 0; s < stage_count; ++s)
      json["stages"][std::string(name(static_cast<Stage>(s)))] =
          stages_[static_cast<std::size_t>(s)];
    return json;
  }

 private:
  Context context_;
  StageClock clock_;
  double best_ = 1e300;
  StageSeconds stages_{};
};

}  // namespace certet::bench
