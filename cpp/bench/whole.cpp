/// The whole engine on the torus, measured against copying its result.
///
/// usage: certet_bench_whole TETS,... THREADS,... REPEATS
/// Prints one JSON object a line for every size with every number of threads.
/// Times are the least of the repeats, in seconds.  The cases take turns and
/// each run is followed by the copies of its mesh, all in this one process, so
/// that the ratios of times mean something.  Peak memory is given for the first
/// case alone: later ones would show that of the earlier.

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "engine_run.hpp"
#include "torus.hpp"

namespace {

using namespace certet;
using namespace certet::bench;

/// Seconds to copy the finished mesh into memory that has been touched before,
/// and into memory fresh from the allocator, as the engine's own output was.
struct CopyTimes {
  double warm = 1e300, fresh = 1e300;
};

CopyTimes least(const CopyTimes& a, const CopyTimes& b) {
  return {std::min(a.warm, b.warm), std::min(a.fresh, b.fresh)};
}

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

/// A torus of some size, meshed by some number of threads.
class Case {
 public:
  Case(double tets, int threads) : torus_(size_for(tets)), engine_(threads) {}

  void run() {
    const Mesh mesh = engine_.run(torus_, torus_.lattice(), {});
    if (peak_ == 0) peak_ = peak_bytes();
    copy_ = least(copy_, copy_mesh(mesh));
    report_ = engine_.report(mesh);
  }

  [[nodiscard]] nlohmann::json report(bool with_peak) const {
    nlohmann::json json = report_;
    json["copy_warm_seconds"] = copy_.warm;
    json["copy_fresh_seconds"] = copy_.fresh;
    if (with_peak) json["peak_bytes"] = peak_;
    return json;
  }

 private:
  Torus torus_;
  EngineRun engine_;
  CopyTimes copy_;
  std::uint64_t peak_ = 0;
  nlohmann::json report_;
};

std::vector<double> numbers(const char* list) {
  std::vector<double> result;
  std::istringstream stream(list);
  for (std::string item; std::getline(stream, item, ',');)
    result.push_back(std::strtod(item.c_str(), nullptr));
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: certet_bench_whole TETS,... THREADS,... REPEATS\n";
    return 2;
  }
  std::deque<Case> cases;
  for (const double tets : numbers(argv[1]))
    for (const double threads : numbers(argv[2]))
      cases.emplace_back(tets, static_cast<int>(threads));
  for (int repeat = std::atoi(argv[3]); repeat > 0; --repeat)
    for (Case& one : cases) one.run();
  for (const Case& one : cases) std::cout << one.report(&one == &cases.front()) << '\n';
}
