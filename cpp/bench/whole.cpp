/// One run of the whole engine, measured against copying its result.
///
/// usage: certet_bench_whole TETS THREADS REPEATS
/// Prints one JSON object.  Times are the least of the repeats, in seconds; all
/// of them are taken in this one process, so that their ratios mean something.

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <nlohmann/json.hpp>

#include "certet/stuffing.hpp"
#include "torus.hpp"

namespace {

using namespace certet;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Seconds by stage, from the engine's progress.
class StageClock {
 public:
  explicit StageClock(Context& context) {
    context.progress = [this](Stage stage, std::int64_t done, std::int64_t) {
      if (done == 0) enter(static_cast<int>(stage));
    };
  }
  void start() {
    seconds_.fill(0);
    current_ = -1;
    last_ = now();
  }
  const std::array<double, 5>& stop() {
    enter(-1);
    return seconds_;
  }

 private:
  void enter(int stage) {
    const double time = now();
    if (current_ >= 0) seconds_[static_cast<std::size_t>(current_)] += time - last_;
    last_ = time;
    current_ = stage;
  }
  std::array<double, 5> seconds_{};
  int current_ = -1;
  double last_ = 0;
};

std::uint64_t mesh_bytes(const Mesh& mesh) {
  return std::visit(
      [&](const auto& tets) {
        return mesh.points.size() * sizeof(Coord3) + tets.size() * sizeof(tets[0]);
      },
      mesh.tets);
}

/// Seconds to copy the finished mesh into memory that has been touched before,
/// and into memory fresh from the allocator, as the engine's own output was.
struct CopyTimes {
  double warm, fresh;
};

CopyTimes copy_mesh(const Mesh& mesh) {
  return std::visit(
      [&](const auto& tets) {
        const std::size_t p = mesh.points.size() * sizeof(Coord3);
        const std::size_t t = tets.size() * sizeof(tets[0]);
        const double start = now();
        Buffer<char> copy(p + t);
        const auto copy_once = [&] {
          std::memcpy(copy.data(), mesh.points.data(), p);
          std::memcpy(copy.data() + p, tets.data(), t);
        };
        copy_once();
        const double middle = now();
        copy_once();
        return CopyTimes{now() - middle, middle - start};
      },
      mesh.tets);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: certet_bench_whole TETS THREADS REPEATS\n";
    return 2;
  }
  const double size = bench::size_for(std::atof(argv[1]));
  const bench::Torus torus(size);
  Context context;
  context.threads = std::atoi(argv[2]);
  StageClock clock(context);

  nlohmann::json result;
  double best = 1e300;
  CopyTimes copy{1e300, 1e300};
  for (int repeat = std::atoi(argv[3]); repeat > 0; --repeat) {
    clock.start();
    const double start = now();
    const Mesh mesh = stuff(torus, torus.lattice(), {}, {}, context);
    const double seconds = now() - start;
    const auto& stages = clock.stop();
    if (result.empty()) {
      rusage usage{};
      getrusage(RUSAGE_SELF, &usage);
      result["peak_bytes"] = usage.ru_maxrss * 1024;
      result["tets"] = mesh.tet_count();
      result["points"] = mesh.points.size();
      result["mesh_bytes"] = mesh_bytes(mesh);
    }
    if (seconds < best) {
      best = seconds;
      for (int s = 0; s < 5; ++s)
        result["stages"][std::string(name(static_cast<Stage>(s)))] = stages[static_cast<std::size_t>(s)];
    }
    const CopyTimes times = copy_mesh(mesh);
    copy = {std::min(copy.warm, times.warm), std::min(copy.fresh, times.fresh)};
  }
  result["threads"] = context.threads;
  result["seconds"] = best;
  result["copy_warm_seconds"] = copy.warm;
  result["copy_fresh_seconds"] = copy.fresh;
  std::cout << result.dump() << '\n';
}
