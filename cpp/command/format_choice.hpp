#pragma once
/// \file
/// The format of an output.

#include <filesystem>
#include <string>

#include "certet/formats.hpp"

namespace certet::command {

/// By its name, or where that is empty by the file's extension; .vtu where there
/// is no file either.  \throws Error `bad_option`.
Format choose_format(const std::filesystem::path& output, const std::string& name,
                     bool compress);

}  // namespace certet::command
