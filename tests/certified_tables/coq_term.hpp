#pragma once
/// \file
/// A constant as a Coq term of type `Table` (Table.v).

#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>

#include "entries.hpp"

namespace certet::tables {

/// Every entry by itself: numbers in full, those in floating point as m 2^e.
template <Entry T>
std::string coq_entry(const T& entry) {
  if constexpr (std::is_same_v<T, std::string_view>) {
    return "Text \"" + std::string(entry) + '"';
  } else if constexpr (std::is_floating_point_v<T>) {
    int exponent;
    const double fraction = std::frexp(entry, &exponent);
    return "Double (" + std::to_string(static_cast<std::int64_t>(std::ldexp(fraction, 53))) +
           ") (" + std::to_string(exponent - 53) + ')';
  } else if constexpr (std::is_enum_v<T>) {
    return coq_entry(static_cast<std::underlying_type_t<T>>(entry));
  } else {
    return "Number (" + std::to_string(entry) + ')';
  }
}

/// Rows in rows, as deep as the type is.
template <class T>
std::string coq_term(const T& value) {
  if constexpr (Entry<T>) {
    return coq_entry(value);
  } else {
    std::string row = "Row [";
    bool first = true;
    for_each_part(value, [&](const auto& part) {
      if (!first) row += "; ";
      first = false;
      row += coq_term(part);
    });
    return row + ']';
  }
}

/// `core::cell_vertex_count` as CppCoreCellVertexCount.
inline std::string coq_name(std::string_view name) {
  std::string result = "Cpp";
  bool upper = true;
  for (const char c : name) {
    const bool separator = c == '_' || c == ':';
    if (!separator) result += upper && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    upper = separator;
  }
  return result;
}

}  // namespace certet::tables
