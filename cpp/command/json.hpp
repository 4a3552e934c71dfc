#pragma once
/// \file
/// JSON for programs.

#include <nlohmann/json.hpp>
#include <string>

namespace certet::command {

using Json = nlohmann::ordered_json;

/// What every report begins with.
inline Json json_of_command(const char* name) {
  return {{"certet", CERTET_VERSION}, {"command", name}};
}

/// Indented, and valid UTF-8 whatever bytes a file name has.
inline std::string print(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace certet::command
