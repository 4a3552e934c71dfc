#pragma once
/// \file
/// Tables for people: a title and a text on each line.

#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <string>
#include <utility>

#include "certet/quality.hpp"

namespace certet::command {

/// Digits in groups of three.
std::string grouped(std::uint64_t number);
/// A number of bytes with a unit.
std::string bytes(std::uint64_t count);

class Lines {
 public:
  template <class... Values>
  void add(std::string_view title, fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), "{:<11}{}\n", title,
                   fmt::format(format, std::forward<Values>(values)...));
  }
  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

/// Least and greatest dihedral angle.
void add_angles(Lines& lines, const Quality& quality);
/// A bar for every bin that is not empty, or for so many bins together.
void add_histogram(Lines& lines, const Quality& quality, std::size_t together = 1);

}  // namespace certet::command
