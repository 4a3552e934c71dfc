#pragma once
/// \file
/// A campaign of trials that are numbered, each of which may have a planted defect:
///
///     PROGRAM [--count N] [--first N] [--seed S] [--threads N] [--plant NAME] [--report FILE.md]

#include <cstdint>
#include <exception>
#include <span>
#include <sstream>
#include <string>

#include "campaign.hpp"

namespace soak {

template <class Plant>
struct NumberedArguments : CampaignArguments {
  std::uint64_t count, first = 0;
  Plant plant{};
};

/// \param count of trials where none is asked for
/// \param plants the names of planted defects, by their numbers
/// \throws std::exception on wrong usage
template <class Plant, class Names>
NumberedArguments<Plant> numbered_arguments(int argc, char** argv, std::uint64_t count,
                                            const Names& plants) {
  NumberedArguments<Plant> arguments{{}, count};
  read_options(argc, argv, [&](const std::string& name, const std::string& value) {
    if (name == "--count") arguments.count = std::stoull(value);
    else if (name == "--first") arguments.first = std::stoull(value);
    else if (name == "--plant") arguments.plant = static_cast<Plant>(number_of(plants, value));
    else return arguments.take(name, value);
    return true;
  });
  return arguments;
}

/// An exception is a fault too.
/// \param judge of a seed, a number and a planted defect
template <class Plant, class Judge>
auto verdicts_of(const NumberedArguments<Plant>& arguments, const Judge& judge) {
  return verdicts_of(arguments.count, arguments.threads, [&](std::uint64_t i) {
    try {
      return judge(arguments.seed, arguments.first + i, arguments.plant);
    } catch (const std::exception& error) {
      decltype(judge(i, i, arguments.plant)) verdict;
      verdict.faults.push_back(std::string("an exception: ") + error.what());
      return verdict;
    }
  });
}

/// The first 20 faults of all verdicts, and how to see each again.
template <class Plant, class Verdict>
std::string faults_of(const std::string& program, const NumberedArguments<Plant>& arguments,
                      std::span<const Verdict> verdicts) {
  std::ostringstream sentences;
  int left = 20;
  for (std::size_t n = 0; n < verdicts.size(); ++n)
    for (const std::string& fault : verdicts[n].faults)
      if (left-- > 0)
        sentences << '\n' << program << " --seed " << arguments.seed << " --first "
                  << arguments.first + n << " --count 1: " << fault << "\n";
  return sentences.str();
}

}  // namespace soak
