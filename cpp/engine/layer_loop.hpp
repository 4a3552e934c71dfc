#pragma once
/// \file
/// Layer by layer, on several threads.

#include <cstdint>

#include "parallel.hpp"
#include "window.hpp"

namespace certet::core {

/// Calls task(k) for every layer of a window, as `parallel_for` does.
template <class Task>
void for_each_layer(Context& context, Stage stage, Window window, const Task& task) {
  parallel_for(context, stage, window.layers(), [&](std::int64_t i) {
    task(window.begin + static_cast<std::int32_t>(i));
  });
}

}  // namespace certet::core
