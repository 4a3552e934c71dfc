#pragma once
/// \file
/// Wall time.

#include <chrono>

namespace certet::command {

/// Seconds since the clock was made.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(clock::now() - start_).count();
  }

 private:
  using clock = std::chrono::steady_clock;
  clock::time_point start_ = clock::now();
};

}  // namespace certet::command
