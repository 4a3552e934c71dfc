#pragma once
/// \file
/// Long runs under Python: without its lock, and stopped by Ctrl-C.

#include <pybind11/pybind11.h>

#include <cstdint>
#include <functional>

#include "certet/context.hpp"

namespace certet::python {

/// Is told, with Python's lock, the stage of a run and how much of it is done, in layers.  What it
/// throws ends the run.
using Follow = std::function<void(Stage, std::int64_t done, std::int64_t total)>;

/// Runs `work` on a thread of its own while this one, without Python's lock,
/// waits, looks for signals and tells `follow`, if there is one.  An exception of `work`, of
/// `follow`, or the KeyboardInterrupt that stopped it, is thrown here.
void run(Context& context, const std::function<void()>& work, const Follow& follow = {});

}  // namespace certet::python
