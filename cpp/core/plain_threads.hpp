#pragma once
/// \file
/// Threads for the thread sanitizer, which sees nothing of what oneTBB does to order
/// its own: under it the same tasks run on plain threads.

#if defined(__SANITIZE_THREAD__)
#define CERTET_PLAIN_THREADS
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CERTET_PLAIN_THREADS
#endif
#endif

#ifdef CERTET_PLAIN_THREADS

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace certet::core {

/// Calls run(i) for every i in [0, count).  The first exception ends the loop and is
/// thrown again.
template <class Run>
void run_on_plain_threads(int threads, std::int64_t count, const Run& run) {
  std::atomic<std::int64_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    try {
      // Relaxed, so that taking a number orders nothing.
      for (;;) {
        const std::int64_t i = next.fetch_add(1, std::memory_order_relaxed);
        if (i >= count) return;
        run(i);
      }
    } catch (...) {
      next.store(count, std::memory_order_relaxed);
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> workers;
    for (int t = 0; t < threads; ++t) workers.emplace_back(work);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace certet::core

#endif
