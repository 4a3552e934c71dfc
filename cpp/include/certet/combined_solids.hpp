#pragma once
/// \file
/// Solids made of two others.

#include "certet/solid.hpp"

namespace certet {

/// What is in both, on a lattice around what their bounds have in common.
/// \throws Error `bad_option` where these have nothing in common.
Solid operator&(const Solid& a, const Solid& b);

/// What is in one of them or in both.
Solid operator|(const Solid& a, const Solid& b);

/// What is in the first and not in the second.
Solid operator-(const Solid& a, const Solid& b);

}  // namespace certet
