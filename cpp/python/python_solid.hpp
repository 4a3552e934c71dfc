#pragma once
/// \file
/// What a `certet.Solid` of Python holds.

#include <string>
#include <vector>

#include "certet/solid.hpp"

namespace certet::python {

/// A solid, and what the user should know of it.
struct PythonSolid {
  Solid solid;
  std::vector<std::string> notes = {};  ///< a sentence each
  double cost = 1;                      ///< of asking about a point, as `SizedShape` has it
};

}  // namespace certet::python
