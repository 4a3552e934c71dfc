#pragma once
/// \file
/// What the user asks for and cannot be had.

#include <string>

#include "certet/error.hpp"

namespace certet::command {

/// \throws Error `bad_option`, always.
[[noreturn]] inline void refuse(const std::string& sentence) {
  throw Error(ErrorCode::bad_option, sentence);
}

}  // namespace certet::command
