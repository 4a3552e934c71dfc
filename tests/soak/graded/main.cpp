/// \file
/// certet_graded_soak: meshes random domains of one and of several materials, grades each by
/// 1 to 3 levels and by sizes that are asked for at random, and judges the mesh beside the
/// uniform one.
///
///     certet_graded_soak [--count N] [--first N] [--seed S] [--threads N] [--plant NAME]
///                        [--report FILE.md]
///
/// Ends with status 1 if a mesh has a fault, 2 on wrong usage.

#include <fstream>
#include <iostream>
#include <sstream>

#include "../campaign.hpp"
#include "graded_trial.hpp"

namespace {

using graded::Verdict;

struct Arguments : soak::CampaignArguments {
  std::uint64_t count = 100, first = 0;
  graded::Plant plant{};
};

/// \throws std::exception on wrong usage
Arguments parse(int argc, char** argv) {
  Arguments arguments;
  soak::read_options(argc, argv, [&](const std::string& name, const std::string& value) {
    if (name == "--count") arguments.count = std::stoull(value);
    else if (name == "--first") arguments.first = std::stoull(value);
    else if (name == "--plant") arguments.plant = static_cast<graded::Plant>(soak::number_of(graded::plant_names, value));
    else return arguments.take(name, value);
    return true;
  });
  return arguments;
}

/// An exception is a fault too.
Verdict judged(std::uint64_t number, const Arguments& arguments) {
  try {
    return graded::judge(arguments.seed, number, arguments.plant);
  } catch (const std::exception& error) {
    Verdict verdict;
    verdict.faults.push_back(std::string("an exception: ") + error.what());
    return verdict;
  }
}

std::uint64_t tell_all(const Arguments& arguments) {
  const std::vector<Verdict> verdicts =
      soak::verdicts_of(arguments.count, arguments.threads, [&](std::uint64_t i) {
        return judged(arguments.first + i, arguments);
      });
  std::uint64_t tets = 0, uniform = 0, several = 0, asked = 0, smaller = 0, faulty = 0;
  std::ostringstream sentences;
  int left = 20;
  for (std::size_t n = 0; n < verdicts.size(); ++n) {
    const Verdict& verdict = verdicts[n];
    tets += verdict.tets;
    uniform += verdict.uniform_tets;
    several += verdict.several;
    asked += verdict.asked;
    smaller += verdict.smaller;
    faulty += !verdict.faults.empty();
    for (const std::string& fault : verdict.faults)
      if (left-- > 0)
        sentences << "\ncertet_graded_soak --seed " << arguments.seed << " --first "
                  << arguments.first + n << " --count 1: " << fault << "\n";
  }
  std::ostringstream table;
  table << "seed " << arguments.seed << ", from " << arguments.first
        << "\n\n| graded meshes | of several materials | with sizes | with fewer tetrahedra than of "
           "one size | tetrahedra | of one size | with a fault |\n|---|---|---|---|---|---|---|\n| "
        << verdicts.size() << " | " << several << " | " << asked << " | " << smaller << " | " << tets
        << " | " << uniform << " | " << faulty << " |\n"
        << sentences.str();
  std::cout << table.str();
  if (!arguments.report.empty()) std::ofstream(arguments.report) << table.str();
  return faulty;
}

}  // namespace

int main(int argc, char** argv) {
  return soak::campaign("certet_graded_soak", [&] { return parse(argc, argv); }, tell_all);
}
