#include "signals.hpp"

#include <csignal>

namespace certet::command {
namespace {

static_assert(std::atomic<bool>::is_always_lock_free, "a handler may not wait");
std::atomic<std::atomic<bool>*> cancelled{nullptr};

void cancel(int) {
  if (auto* flag = cancelled.load()) *flag = true;
}

void handle(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

}  // namespace

Signals::Signals(Context& context) {
  cancelled = &context.cancelled;
  handle(cancel);
}

Signals::~Signals() {
  handle(SIG_DFL);
  cancelled = nullptr;
}

void ignore_write_signals() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace certet::command
