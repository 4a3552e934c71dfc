#pragma once
/// \file
/// Private to the bridge: from OCaml's integers to those of the engine.

#include <cstdint>
#include <limits>
#include <string>

#include "certified.hpp"

namespace certified {

/// \throws Failure if the number does not fit 32 bits
inline std::int32_t narrow(std::int64_t n) {
  using Limits = std::numeric_limits<std::int32_t>;
  if (n < Limits::min() || n > Limits::max())
    throw Failure(std::to_string(n) + " does not fit in 32 bits");
  return static_cast<std::int32_t>(n);
}

}  // namespace certified
