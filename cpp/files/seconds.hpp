#pragma once
/// \file
/// Time spent by many threads.

#include <atomic>
#include <chrono>
#include <cstdint>

namespace certet::pipeline {

/// Nanoseconds that several threads add to.
using Nanoseconds = std::atomic<std::int64_t>;

inline double seconds(const Nanoseconds& time) { return 1e-9 * static_cast<double>(time); }

/// Adds the time of its life.
class Timer {
 public:
  explicit Timer(Nanoseconds& time) : time_(time) {}
  ~Timer() {
    time_ += std::chrono::duration_cast<std::chrono::nanoseconds>(clock::now() - start_).count();
  }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

 private:
  using clock = std::chrono::steady_clock;
  Nanoseconds& time_;
  clock::time_point start_ = clock::now();
};

}  // namespace certet::pipeline
