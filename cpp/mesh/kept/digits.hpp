#pragma once
/// \file
/// Numbers in sentences.

#include <array>
#include <cstdio>
#include <string>

namespace certet::core {

/// So many significant digits, as %g has them.
inline std::string digits(double value, int count) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", count, value);
  return text.data();
}

}  // namespace certet::core
