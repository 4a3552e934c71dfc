#pragma once
/// \file
/// What every campaign does: reads its arguments, judges many trials in threads, and ends
/// with 0 where all were sound, 1 where one was not, 2 on wrong usage.

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace soak {

/// Hands out the values of options by their names, `--name value` each.
/// \param take whether it knows the name
/// \throws std::exception on wrong usage
template <class Take>
void read_options(int argc, char** argv, const Take& take) {
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (i + 1 == argc) throw std::invalid_argument(name + " has no value");
    if (!take(name, std::string(argv[i + 1]))) throw std::invalid_argument(name + " is no option");
  }
}

/// \throws std::exception where a name is not among those there are.
template <class Names>
std::size_t number_of(const Names& names, const std::string& name) {
  const auto at = std::ranges::find(names, name);
  if (at == names.end()) throw std::invalid_argument("there is no " + name);
  return static_cast<std::size_t>(at - names.begin());
}

/// What every campaign may be told.
struct CampaignArguments {
  std::uint64_t seed = std::random_device{}();
  unsigned threads = 2;
  std::string report;

  /// \returns whether it is one of these options
  bool take(const std::string& name, const std::string& value) {
    if (name == "--seed") seed = std::stoull(value);
    else if (name == "--threads") threads = static_cast<unsigned>(std::stoul(value));
    else if (name == "--report") report = value;
    else return false;
    return true;
  }
};

/// The verdicts on trials 0 to count - 1, by the trial.
template <class Judge>
auto verdicts_of(std::uint64_t count, unsigned threads, const Judge& judge) {
  std::vector<decltype(judge(std::uint64_t{}))> verdicts(count);
  std::atomic<std::uint64_t> next{0};
  std::vector<std::jthread> workers;
  for (unsigned t = 0; t < std::max(1U, threads); ++t)
    workers.emplace_back([&] {
      for (std::uint64_t i; (i = next++) < count;) verdicts[i] = judge(i);
    });
  workers.clear();
  return verdicts;
}

/// To the terminal, and to the file that was asked for.
inline void tell(const CampaignArguments& arguments, const std::string& table) {
  std::cout << table;
  if (!arguments.report.empty()) std::ofstream(arguments.report) << table;
}

/// parse() may throw; run(arguments) says how many trials had a fault.
template <class Parse, class Run>
int campaign(const std::string& program, const Parse& parse, const Run& run) {
  try {
    const auto arguments = parse();
    std::cout << "seed " << arguments.seed << std::endl;
    return run(arguments) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << program << ": " << error.what() << '\n';
    return 2;
  }
}

}  // namespace soak
