#include "run.hpp"

#include <chrono>
#include <future>

namespace certet::python {

namespace py = pybind11;

void run(Context& context, const std::function<void()>& work) {
  std::future<void> done = std::async(std::launch::async, work);
  bool interrupted = false;
  std::future_status status;
  do {
    {
      const py::gil_scoped_release unlocked;
      status = done.wait_for(std::chrono::milliseconds(20));
    }
    if (!interrupted && PyErr_CheckSignals() != 0) {
      interrupted = true;
      context.cancelled = true;
      PyErr_Clear();
    }
  } while (status != std::future_status::ready);
  if (interrupted) {
    try {
      done.get();
    } catch (...) {  // that it was cancelled
    }
    PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw py::error_already_set();
  }
  done.get();
}

}  // namespace certet::python
