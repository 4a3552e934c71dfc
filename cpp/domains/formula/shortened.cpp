#include <algorithm>

#include "certet/formula.hpp"

namespace certet {
namespace {

/// Whether UTF-8 may be cut before a byte.
bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

}  // namespace

std::string shortened_formula(const std::string& formula, std::size_t around) {
  constexpr std::size_t longest = 200, before = 60, shown = 120;
  if (formula.size() <= longest) return formula;
  std::size_t begin = around > before ? std::min(around - before, formula.size() - shown) : 0;
  std::size_t end = begin + shown;
  while (begin > 0 && !begins_character(formula[begin])) --begin;
  while (end < formula.size() && !begins_character(formula[end])) ++end;
  return (begin > 0 ? "..." : "") + formula.substr(begin, end - begin) +
         (end < formula.size() ? "..." : "");
}

}  // namespace certet
