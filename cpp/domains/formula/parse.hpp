#pragma once
/// \file
/// From the text of a formula to its operations.

#include <string>

#include "tape.hpp"

namespace certet {

/// Records a formula in x, y, z on a tape.  \throws Error `bad_input`, a
/// sentence with the position of the fault.
NodeId parse(const std::string& formula, Tape& tape);

}  // namespace certet
