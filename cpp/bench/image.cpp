/// The engine alone on the labels of an image, to compare the command with.
///
/// usage: certet_bench_image FILE SIZE CUTS THREADS REPEATS
/// CUTS is bisect or midpoint.  Prints one JSON object; times are in
/// seconds, those of the engine the least of the repeats.

#include <cstdlib>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "certet/error.hpp"
#include "certet/image.hpp"
#include "engine_run.hpp"

namespace {

using namespace certet;
using namespace certet::bench;

nlohmann::json measure(const char* file, double size, Method method, int threads, int repeats) {
  const double start = now();
  const auto domain = label_domain(
      read_image(file, std::numeric_limits<std::uint64_t>::max()), {},
      {.size = size, .walls_halfway = !facts(method).settles});
  const double read_seconds = now() - start;
  EngineRun engine(threads);
  nlohmann::json json;
  for (; repeats > 0; --repeats)
    json = engine.report(engine.run(*domain, domain->lattice(), method));
  json["read_seconds"] = read_seconds;
  json["peak_bytes"] = peak_bytes();
  return json;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    std::cerr << "usage: certet_bench_image FILE SIZE CUTS THREADS REPEATS\n";
    return 2;
  }
  try {
    const Method method =
        std::string_view(argv[3]) == "midpoint" ? Method::midpoint : default_method;
    std::cout << measure(argv[1], std::atof(argv[2]), method, std::atoi(argv[4]),
                         std::atoi(argv[5]))
              << '\n';
  } catch (const Error& error) {
    std::cerr << "certet_bench_image: " << error.what() << '\n';
    return 1;
  }
}
