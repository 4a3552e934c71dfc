#pragma once
/// \file
/// Long runs under Python: without its lock, and stopped by Ctrl-C.

#include <pybind11/pybind11.h>

#include <functional>

#include "certet/context.hpp"

namespace certet::python {

/// Runs `work` on a thread of its own while this one, without Python's lock,
/// waits and looks for signals.  An exception of `work`, or the
/// KeyboardInterrupt that stopped it, is thrown here.
void run(Context& context, const std::function<void()>& work);

}  // namespace certet::python
