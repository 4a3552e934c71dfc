#pragma once
/// \file
/// The one place where threads are made: oneTBB where it was found, otherwise
/// a plain loop.

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>

#ifdef CERTET_HAS_TBB
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include "certet/context.hpp"
#include "certet/error.hpp"
#include "plain_threads.hpp"

namespace certet::core {

/// Counts finished tasks, reports them, and stops a run that was cancelled.
class StageProgress {
 public:
  StageProgress(Context& context, Stage stage, std::int64_t total)
      : context_(context), stage_(stage), total_(total) {
    if (context_.progress) context_.progress(stage_, 0, total_);
  }

  void check_cancelled() const {
    if (context_.cancelled.load(std::memory_order_relaxed))
      throw Error(ErrorCode::cancelled, "the run was cancelled");
  }

  void task_done() {
    if (!context_.progress) return;
    const std::lock_guard lock(mutex_);
    context_.progress(stage_, ++done_, total_);
  }

 private:
  Context& context_;
  Stage stage_;
  std::int64_t total_;
  std::int64_t done_ = 0;
  std::mutex mutex_;
};

/// Calls task(i) for every i in [0, count), in any order and on several
/// threads.  Tasks must not depend on each other.
template <class Task>
void parallel_for(Context& context, Stage stage, std::int64_t count, const Task& task) {
  StageProgress progress(context, stage, count);
  const auto run = [&](std::int64_t i) {
    progress.check_cancelled();
    task(i);
    progress.task_done();
  };
#if defined(CERTET_PLAIN_THREADS)
  if (context.threads != 1)
    return run_on_plain_threads(context.threads > 0 ? context.threads : 2, count, run);
#elif defined(CERTET_HAS_TBB)
  const int threads = context.threads > 0 ? context.threads
                                          : tbb::this_task_arena::max_concurrency();
  if (threads > 1) {
    // Only ever raised: the arena keeps to `threads`, and another run at the same
    // time may want more.
    constexpr auto parallelism = tbb::global_control::max_allowed_parallelism;
    const tbb::global_control workers(parallelism,
                                      std::max(static_cast<std::size_t>(threads),
                                               tbb::global_control::active_value(parallelism)));
    tbb::task_arena arena(threads);
    arena.execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::int64_t>(0, count, 1),
          [&](const tbb::blocked_range<std::int64_t>& range) {
            for (std::int64_t i = range.begin(); i < range.end(); ++i) run(i);
          },
          tbb::simple_partitioner());
    });
    progress.check_cancelled();
    return;
  }
#endif
  for (std::int64_t i = 0; i < count; ++i) run(i);
}

}  // namespace certet::core
