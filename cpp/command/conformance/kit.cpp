#include "kit.hpp"

#include <cstddef>

extern "C" {
extern const char certet_kit_begin[];
extern const char certet_kit_end[];
}

namespace certet::command {

std::string_view conformance_kit() {
  return {certet_kit_begin, static_cast<std::size_t>(certet_kit_end - certet_kit_begin)};
}

}  // namespace certet::command
