#pragma once
/// \file
/// Files of shapes that cannot be read, or are not what they should be.

#include <filesystem>
#include <string>
#include <system_error>

#include "certet/error.hpp"

namespace certet {

/// \throws Error `bad_input`, always: the file and the reason in one sentence.
[[noreturn]] inline void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw Error(ErrorCode::bad_input, "'" + file.string() + "' " + reason);
}

/// Refuses what is not there, or is a folder or a device.
inline void check_is_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) refuse(file, "does not exist");
  if (!std::filesystem::is_regular_file(file, ignored)) refuse(file, "is not a file");
}

}  // namespace certet
