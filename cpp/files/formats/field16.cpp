#include "field16.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>

namespace certet::formats {
namespace {

constexpr std::size_t width = 16;

double value_of(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Fields are told from whole numbers by their point.
std::string with_point(std::string text) {
  if (text.find_first_of(".n") == std::string::npos)  // inf and nan have none
    text.insert(std::min(text.find('e'), text.size()), 1, '.');
  return text;
}

template <class... Form>
std::string written(double number, Form... form) {
  std::array<char, 400> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number, form...).ptr;
  return with_point({text.data(), end});
}

/// With as many digits behind the point as fit; none where not even one does.
std::optional<std::string> longest(double number, std::chars_format form) {
  const std::size_t bare = written(number, form, 0).size();
  if (bare > width) return std::nullopt;
  for (std::size_t digits = width - bare;; --digits) {
    std::string text = written(number, form, static_cast<int>(digits));
    if (text.size() <= width) return text;  // rounding up can take one more
  }
}

}  // namespace

std::string field16(double number) {
  std::string shortest = written(number);
  if (shortest.size() <= width) return shortest;
  const std::string scientific = *longest(number, std::chars_format::scientific);
  const auto fixed = longest(number, std::chars_format::fixed);
  const auto error = [&](const std::string& text) { return std::abs(value_of(text) - number); };
  return fixed && error(*fixed) <= error(scientific) ? *fixed : scientific;
}

std::array<std::string, 3> Fields16::fields(const Point3& point) {
  const std::array fields{field16(point[0]), field16(point[1]), field16(point[2])};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low_[axis] = any_ ? std::min(low_[axis], point[axis]) : point[axis];
    high_[axis] = any_ ? std::max(high_[axis], point[axis]) : point[axis];
    rounding_ = std::max(rounding_, std::abs(value_of(fields[axis]) - point[axis]));
  }
  any_ = true;
  return fields;
}

void Fields16::finish(const OutputFile& file) const {
  constexpr double most = 1e-9;
  double length = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) length = std::max(length, high_[axis] - low_[axis]);
  if (rounding_ > most * length)
    file.fail("its fields are 16 characters wide, in which coordinates so far from 0, beside the "
              "mesh's length, are too coarse; with the origin at 0 they are finer");
}

}  // namespace certet::formats
