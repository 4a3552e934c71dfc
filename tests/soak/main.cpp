/// \file
/// certet_soak: meshes many random domains and verifies every mesh.
///
///     certet_soak [--count N] [--seed S] [--only N] [--threads N] [--plant NAME]
///                 [--report FILE]       writes FILE.json and FILE.md
///
/// Ends with status 1 if a mesh has a fault, 2 on wrong usage.

#include <chrono>
#include <fstream>
#include <iostream>

#include "campaign.hpp"
#include "report.hpp"
#include "seed.hpp"
#include "verify.hpp"

namespace {

struct Arguments : soak::CampaignArguments {
  std::uint64_t count = 200, first = 0;
  soak::Plant plant = soak::Plant::nothing;
};

/// \throws std::exception on wrong usage
Arguments parse(int argc, char** argv) {
  Arguments arguments;
  soak::read_options(argc, argv, [&](const std::string& name, const std::string& value) {
    if (name == "--count") {
      arguments.count = std::stoull(value);
    } else if (name == "--only") {
      arguments.first = std::stoull(value);
      arguments.count = 1;
    } else if (name == "--plant") {
      arguments.plant = static_cast<soak::Plant>(soak::number_of(soak::plant_names, value));
    } else {
      return arguments.take(name, value);
    }
    return true;
  });
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
