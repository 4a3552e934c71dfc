#pragma once
/// \file
/// Loops over many things, in runs that are worked on side by side.

#include <algorithm>
#include <cstddef>

#include "engine/memory.hpp"
#include "engine/parallel.hpp"

namespace certet::distance {

inline constexpr std::size_t run_length = 1024;

constexpr std::size_t run_count(std::size_t things) {
  return (things + run_length - 1) / run_length;
}

/// Calls work(first, last, run) for runs of things.
template <class Work>
void in_runs(std::size_t things, Context& context, const Work& work) {
  const auto runs = static_cast<std::int64_t>(run_count(things));
  core::parallel_for(context, Stage::emit, runs, [&](std::int64_t number) {
    const auto run = static_cast<std::size_t>(number);
    work(run * run_length, std::min((run + 1) * run_length, things), run);
  });
}

template <class Work>
auto in_memory(const Work& work) {
  return core::within_memory("out of memory while measuring distances", work);
}

}  // namespace certet::distance
