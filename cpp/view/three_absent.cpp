// Stands in for three.js where it was left out.

#include "page_parts.hpp"

namespace certet::view {

std::string_view three_library() { return {}; }
std::string_view three_controls() { return {}; }

}  // namespace certet::view
