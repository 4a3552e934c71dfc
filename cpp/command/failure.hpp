#pragma once
/// \file
/// What is said of a run that fails.

#include <string>

#include "status.hpp"

namespace certet::command {

struct Failure {
  Status status;
  std::string sentence;  ///< on one line
};

/// Of the exception that is being handled.
Failure current_failure();

}  // namespace certet::command
