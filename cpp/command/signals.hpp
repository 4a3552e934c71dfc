#pragma once
/// \file
/// Signals that end a run in good order.

#include "certet/context.hpp"

namespace certet::command {

/// While it lives, SIGINT, SIGTERM and SIGHUP cancel the context.
class Signals {
 public:
  explicit Signals(Context& context);
  ~Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;
};

/// Makes a full disk quota or a closed pipe an error of the write, not a death.
void ignore_write_signals();

}  // namespace certet::command
