#include "option_values.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "refusal.hpp"

namespace certet::command {
namespace {

/// Reads a whole number at the front of `text` and removes it.
bool take_integer(std::string_view& text, std::int64_t& value) {
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

bool take_range(std::string_view& text, LabelRange& range) {
  if (!take_integer(text, range.first)) return false;
  range.last = range.first;
  if (!text.starts_with('-')) return true;
  text.remove_prefix(1);
  return take_integer(text, range.last) && range.first <= range.last;
}

/// The number that all of a text is, if it is a finite one of its kind.
template <class Number>
std::optional<Number> number_of(std::string_view text) {
  Number value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, value);
  if (failure != std::errc{} || stop != end || !std::isfinite(static_cast<double>(value)))
    return std::nullopt;
  return value;
}

}  // namespace

std::vector<LabelRange> parse_labels(const std::string& text) {
  std::vector<LabelRange> ranges;
  std::string_view rest = text;
  while (true) {
    LabelRange range{};
    if (!take_range(rest, range) || (!rest.empty() && rest[0] != ','))
      refuse("--labels takes labels and ranges like 1,5-9, not '" + text + "'");
    ranges.push_back(range);
    if (rest.empty()) return ranges;
    rest.remove_prefix(1);
  }
}

double parse_number(const std::string& option, const std::string& text) {
  const auto value = number_of<double>(text);
  if (!value) refuse(option + " takes finite numbers, not '" + text + "'");
  return *value;
}

double parse_positive(const std::string& option, const std::string& text) {
  const double value = parse_number(option, text);
  if (value <= 0) refuse(option + " takes a positive number, not '" + text + "'");
  return value;
}

std::uint64_t parse_count(const std::string& option, const std::string& text) {
  const auto value = number_of<std::uint64_t>(text);
  if (!value || *value == 0)
    refuse(option + " takes a whole number of at least 1, not '" + text + "'");
  return *value;
}

std::uint64_t parse_whole(const std::string& option, const std::string& text) {
  const auto value = number_of<std::uint64_t>(text);
  if (!value) refuse(option + " takes a whole number, 0 or more, not '" + text + "'");
  return *value;
}

KeepRule parse_keep(const std::string& text) {
  const std::optional<KeepRule> rule = keep_rule(text);
  if (!rule)
    refuse("--keep takes largest, a number of pieces, or percolating:x, y or z, not '" + text +
           "'");
  return *rule;
}

std::vector<double> parse_numbers(const std::string& option, const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    numbers.push_back(parse_number(option, text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return numbers;
}

Bounds parse_bounds(const std::string& text, const std::string& option) {
  const std::vector<double> numbers = parse_numbers(option, text);
  if (numbers.size() != 6)
    refuse(option + " takes six numbers x0,y0,z0,x1,y1,z1, not " +
           std::to_string(numbers.size()));
  return {{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
}

Point3 parse_spacing(const std::string& text) {
  const std::vector<double> numbers = parse_numbers("--spacing", text);
  if (numbers.size() != 3)
    refuse("--spacing takes three numbers a,b,c, not " + std::to_string(numbers.size()));
  for (const double number : numbers)
    if (!(number > 0)) refuse("--spacing takes positive numbers, not '" + text + "'");
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace certet::command
