#pragma once
/// \file
/// The conformance kit, as it is in the program.

#include <string_view>

namespace certet::command {

/// The text of tests/conformance/kit.json.
std::string_view conformance_kit();

}  // namespace certet::command
