#pragma once
/// \file
/// Work that is done tile by tile, on several threads.

#include <cstddef>
#include <cstdint>

#include "certet/context.hpp"
#include "engine/parallel.hpp"

namespace certet::fields {

/// Calls task(tile) for every number below `count`, in any order.
/// \throws Error `cancelled`, and what a task throws.
template <class Task>
void for_each_tile(const Context& context, std::size_t count, const Task& task) {
  const auto run = [&](std::int64_t tile) {
    stop_if_cancelled(context);
    task(static_cast<std::size_t>(tile));
  };
  const int threads = core::thread_count(context);
  core::SharedLoop loop(static_cast<std::int64_t>(count), threads, run);
  if (threads == 1)
    loop.work();
  else
    core::on_threads(threads, [&] { loop.work(); });
  loop.finish();
}

}  // namespace certet::fields
