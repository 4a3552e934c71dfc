/// \file
/// certet_soak: meshes many random domains and verifies every mesh.
///
///     certet_soak [--count N] [--seed S] [--only N] [--threads N] [--plant NAME]
///                 [--report FILE]       writes FILE.json and FILE.md
///
/// Ends with status 1 if a mesh has a fault, 2 on wrong usage.

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "campaign.hpp"
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
  return soak::verdicts_of(arguments.count, arguments.threads, [&](std::uint64_t i) {
    return judged(arguments.seed, arguments.first + i, arguments.plant);
  });
}

std::uint64_t tell(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const soak::Summary summary{arguments.seed, arguments.first, run(arguments)};
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::cout << soak::as_markdown(summary);
  std::cout << elapsed.count() << " s\n";
  if (!arguments.report.empty()) {
    std::ofstream(arguments.report + ".md") << soak::as_markdown(summary);
    std::ofstream(arguments.report + ".json") << soak::as_json(summary);
  }
  return soak::faulty(summary);
}

}  // namespace

int main(int argc, char** argv) {
  return soak::campaign("certet_soak", [&] { return parse(argc, argv); }, tell);
}
