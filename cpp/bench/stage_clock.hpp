#pragma once
/// \file
/// What the benchmarks measure time with.

#include <array>
#include <chrono>
#include <cstdint>

#include "certet/context.hpp"

namespace certet::bench {

/// Seconds since some fixed moment.
inline double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

inline constexpr int stage_count = 5;

/// Seconds by stage, indexed by `Stage`.
using StageSeconds = std::array<double, stage_count>;

/// Divides the time of a run among the engine's stages, by its progress.
class StageClock {
 public:
  /// Listens to the context's progress, as long as both live.
  explicit StageClock(Context& context) {
    context.progress = [this](Stage stage, std::int64_t done, std::int64_t) {
      if (done == 0) enter(static_cast<int>(stage));
    };
  }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

  void start() {
    seconds_.fill(0);
    current_ = -1;
    last_ = now();
  }
  const StageSeconds& stop() {
    enter(-1);
    return seconds_;
  }

 private:
  void enter(int stage) {
    const double time = now();
    if (current_ >= 0) seconds_[static_cast<std::size_t>(current_)] += time - last_;
    last_ = time;
    current_ = stage;
  }

  StageSeconds seconds_{};
  int current_ = -1;
  double last_ = 0;
};

}  // namespace certet::bench
