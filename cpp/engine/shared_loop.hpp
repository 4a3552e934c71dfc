#pragma once
/// \file
/// A loop that several threads run together.

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace certet::core {

/// Calls run(i) once for every i in [0, count), on whichever threads call `work`.
/// Each begins at a part of its own, for neighbouring turns write to neighbouring
/// memory, and then helps with the other parts.
template <class Run>
class SharedLoop {
 public:
  SharedLoop(std::int64_t count, int threads, const Run& run)
      : parts_(static_cast<std::size_t>(threads)), run_(run) {
    for (int t = 0; t < threads; ++t) {
      Part& part = parts_[static_cast<std::size_t>(t)];
      part.next = count * t / threads;
      part.end = count * (t + 1) / threads;
    }
  }

  /// Takes turns until none is left, or one has thrown.
  void work() noexcept {
    const std::size_t own = arrived_++ % parts_.size();
    try {
      for (std::size_t p = 0; p < parts_.size(); ++p) work_on(parts_[(own + p) % parts_.size()]);
    } catch (...) {
      for (Part& part : parts_) part.next = part.end;
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }

  /// After all threads have worked: throws what the first turn to fail threw.
  void finish() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  struct alignas(64) Part {
    std::atomic<std::int64_t> next;
    std::int64_t end;
  };

  void work_on(Part& part) {
    // Relaxed: to take a turn orders nothing, so that the thread sanitizer sees what
    // turns owe to each other.
    for (std::int64_t i; (i = part.next.fetch_add(1, std::memory_order_relaxed)) < part.end;)
      run_(i);
  }

  std::vector<Part> parts_;
  const Run& run_;
  std::atomic<std::size_t> arrived_ = 0;
  std::exception_ptr failure_;
  std::mutex mutex_;
};

/// Calls work() on the calling thread and on `threads` - 1 new ones, or on as many of
/// them as the machine grants.
template <class Work>
void on_own_threads(int threads, const Work& work) {
  std::vector<std::jthread> others;
  try {
    others.reserve(static_cast<std::size_t>(threads));
    for (int t = 1; t < threads; ++t) others.emplace_back(work);
  } catch (const std::system_error&) {
    // Fewer threads do the same, only later.
  }
  work();
}

}  // namespace certet::core
