#pragma once
/// \file
/// Solids made of two others.

#include "certet/solid.hpp"

namespace certet {

// The lattice of its own is that of the first which has one.  Of labels that stay apart in the
// first solid they do so in `a & b` and `a - b`; `a | b` is of one material.

/// What is in both, on a lattice around what their bounds have in common.
/// \throws Error `bad_option` where these have nothing in common.
Solid operator&(const Solid& a, const Solid& b);

/// What is in one of them or in both.
Solid operator|(const Solid& a, const Solid& b);

/// What is in the first and not in the second.
Solid operator-(const Solid& a, const Solid& b);

}  // namespace certet
