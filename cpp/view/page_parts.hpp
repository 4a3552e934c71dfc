#pragma once
/// \file
/// The texts that a page is put together from; they are in the folder page/ and
/// in the package of three.js, and become part of the program when it is built.

#include <string_view>

namespace certet::view {

std::string_view page_skeleton();
std::string_view page_style();
std::string_view page_script();
/// Empty where three.js was left out.
std::string_view three_library();
std::string_view three_controls();

}  // namespace certet::view
