/// \file
/// certet_soak: meshes many random domains and verifies every mesh.
///
///     certet_soak [--count N] [--seed S] [--only N] [--threads N] [--plant NAME]
///                 [--report FILE]       writes FILE.json and FILE.md
///
/// Ends with status 1 if a mesh has a fault, 2 on wrong usage.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <thread>

#include "report.hpp"
#include "seed.hpp"
#include "verify.hpp"

namespace {

struct Arguments {
  std::uint64_t count = 200, seed = 0, first = 0;
  unsigned threads = 2;
  soak::Plant plant = soak::Plant::nothing;
  std::string report;
};

/// \throws std::exception on wrong usage
Arguments parse(int argc, char** argv) {
  Arguments arguments;
  bool seeded = false;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (i + 1 == argc) throw std::invalid_argument(name + " has no value");
    const std::string value = argv[i + 1];
    if (name == "--count") arguments.count = std::stoull(value);
    else if (name == "--threads") arguments.threads = static_cast<unsigned>(std::stoul(value));
    else if (name == "--report") arguments.report = value;
    else if (name == "--seed") {
      arguments.seed = std::stoull(value);
      seeded = true;
    } else if (name == "--only") {
      arguments.first = std::stoull(value);
      arguments.count = 1;
    } else if (name == "--plant") {
      const auto at = std::ranges::find(soak::plant_names, value);
      if (at == soak::plant_names.end()) throw std::invalid_argument(value + " is no plant");
      arguments.plant = static_cast<soak::Plant>(at - soak::plant_names.begin());
    } else {
      throw std::invalid_argument(name + " is no option");
    }
  }
  if (!seeded) arguments.seed = std::random_device{}();
  return arguments;
}

/// An exception is a fault too.
soak::Verdict judged(std::uint64_t seed, std::uint64_t number, soak::Plant plant) {
  try {
    return soak::verify(soak::make_trial(seed, number), plant);
  } catch (const std::exception& error) {
    soak::Verdict verdict;
    verdict.kind = static_cast<soak::Kind>(number % soak::kind_count);
    verdict.faults.push_back(std::string("an exception: ") + error.what());
    return verdict;
  }
}

std::vector<soak::Verdict> run(const Arguments& arguments) {
  std::vector<soak::Verdict> verdicts(arguments.count);
  std::atomic<std::uint64_t> next{0};
  std::vector<std::jthread> workers;
  for (unsigned t = 0; t < std::max(1U, arguments.threads); ++t)
    workers.emplace_back([&] {
      for (std::uint64_t i; (i = next++) < arguments.count;)
        verdicts[i] = judged(arguments.seed, arguments.first + i, arguments.plant);
    });
  return workers.clear(), verdicts;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  try {
    arguments = parse(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "certet_soak: " << error.what() << '\n';
    return 2;
  }
  std::cout << "seed " << arguments.seed << std::endl;
  const auto start = std::chrono::steady_clock::now();
  const soak::Summary summary{arguments.seed, arguments.first, run(arguments)};
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::cout << soak::as_markdown(summary);
  std::cout << elapsed.count() << " s\n";
  if (!arguments.report.empty()) {
    std::ofstream(arguments.report + ".md") << soak::as_markdown(summary);
    std::ofstream(arguments.report + ".json") << soak::as_json(summary);
  }
  return soak::faulty(summary) == 0 ? 0 : 1;
}
