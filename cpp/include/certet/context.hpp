#pragma once
/// \file
/// How a caller follows and stops a long run.

#include <atomic>
#include <cstdint>
#include <functional>
#include <string_view>

#include "certet/error.hpp"

namespace certet {

/// The stages of the engine, in the order in which data flows through them.
enum class Stage { sample, cut, warp, count, emit };

constexpr std::string_view name(Stage stage) {
  constexpr std::string_view names[] = {"sample", "cut", "warp", "count", "emit"};
  return names[static_cast<int>(stage)];
}

/// Shared between a run and its caller.  All members may be left as they are.
struct Context {
  /// Set from anywhere (a signal handler too): the run ends with
  /// `Error{ErrorCode::cancelled}` at the next layer.
  std::atomic<bool> cancelled{false};

  /// Called now and then from worker threads, never from two at once, with the
  /// layers done and the layers in all of the current stage.
  std::function<void(Stage, std::int64_t done, std::int64_t total)> progress;

  /// Worker threads to use; 0 means as many as the machine has.
  int threads = 0;
};

/// What a long loop asks now and then.  \throws Error `cancelled`.
inline void stop_if_cancelled(const Context& context) {
  if (context.cancelled) throw Error(ErrorCode::cancelled, "the run was interrupted");
}

}  // namespace certet
