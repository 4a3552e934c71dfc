#pragma once
/// \file
/// The one place where threads are made: oneTBB's where it was found, otherwise
/// a plain loop.

#include <algorithm>
#include <cstdint>
#include <mutex>

#ifdef CERTET_HAS_TBB
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#endif

#include "certet/context.hpp"
#include "shared_loop.hpp"
#include "thread_sanitizer.hpp"

namespace certet::core {

/// Counts finished tasks and reports them.
class StageProgress {
 public:
  StageProgress(Context& context, Stage stage, std::int64_t total)
      : context_(context), stage_(stage), total_(total) {
    if (context_.progress) context_.progress(stage_, 0, total_);
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

/// How many threads a run may use.
inline int thread_count(const Context& context) {
  if (context.threads > 0) return context.threads;
#if defined(CERTET_HAS_TBB)
  return tbb::this_task_arena::max_concurrency();
#else
  return 1;
#endif
}

/// For what the engine does within a single layer.
struct OneThread : Context {
  OneThread() { threads = 1; }
};

/// Calls work() on up to `threads` threads at once.
template <class Work>
void on_threads(int threads, const Work& work) {
#if defined(CERTET_THREAD_SANITIZER)
  on_own_threads(threads, work);
#elif defined(CERTET_HAS_TBB)
  if (threads > tbb::this_task_arena::max_concurrency()) return on_own_threads(threads, work);
  // In the arena that the caller's thread has anyway.  To make one for each loop has
  // oneTBB slow down by a factor of 20 within a minute, if two threads do so.
  tbb::parallel_for(0, threads, [&](int) { work(); }, tbb::simple_partitioner());
#else
  static_cast<void>(threads);
  work();
#endif
}

/// Calls task(i) for every i in [0, count), in any order and on several
/// threads.  Tasks must not depend on each other.
template <class Task>
void parallel_for(Context& context, Stage stage, std::int64_t count, const Task& task) {
  StageProgress progress(context, stage, count);
  const auto run = [&](std::int64_t i) {
    stop_if_cancelled(context);
    task(i);
    progress.task_done();
  };
  const int threads = thread_count(context);
  SharedLoop loop(count, threads, run);
  if (threads == 1)
    loop.work();
  else
    on_threads(threads, [&] { loop.work(); });
  loop.finish();
}

}  // namespace certet::core
