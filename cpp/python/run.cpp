#include "run.hpp"

#include <chrono>
#include <exception>
#include <future>
#include <mutex>
#include <optional>
#include <utility>

namespace certet::python {
namespace {

namespace py = pybind11;

/// How far a run is, told by its threads and asked for by the one that waits.
class Place {
 public:
  void set(Stage stage, std::int64_t done, std::int64_t total) {
    const std::lock_guard locked(mutex_);
    now_ = {stage, done, total};
  }
  /// Nothing where it is as it was when it was last taken.
  struct Now {
    Stage stage;
    std::int64_t done, total;
  };
  std::optional<Now> take() {
    const std::lock_guard locked(mutex_);
    return std::exchange(now_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::optional<Now> now_;
};

/// What is to be thrown here once the work has ended, if there is something to look at now.
std::exception_ptr look(Place& place, const Follow& follow) {
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (const auto now = place.take(); now && follow) follow(now->stage, now->done, now->total);
    return nullptr;
  } catch (...) {
    return std::current_exception();
  }
}

}  // namespace

void run(Context& context, const std::function<void()>& work, const Follow& follow) {
  Place place;
  if (follow)
    context.progress = [&place](Stage stage, std::int64_t done, std::int64_t total) {
      place.set(stage, done, total);
    };
  std::future<void> done = std::async(std::launch::async, work);
  std::exception_ptr stopped;
  std::future_status status;
  do {
    {
      const py::gil_scoped_release unlocked;
      status = done.wait_for(std::chrono::milliseconds(20));
    }
    if (!stopped && (stopped = look(place, follow))) context.cancelled = true;
  } while (status != std::future_status::ready);
  context.progress = nullptr;
  if (!stopped) return done.get();
  try {
    done.get();
  } catch (...) {  // that it was cancelled
  }
  std::rethrow_exception(stopped);
}

}  // namespace certet::python
