#pragma once
/// \file
/// What every campaign does: reads its arguments, judges many trials in threads, and ends
/// with 0 where all were sound, 1 where one was not, 2 on wrong usage.

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

namespace soak {

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
