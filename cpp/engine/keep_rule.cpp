#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

#include "certet/pieces.hpp"

namespace certet {

std::optional<KeepRule> keep_rule(std::string_view text) {
  constexpr std::string_view axes = "xyz", through = "percolating:";
  if (text == "largest") return KeepLargest{1};
  if (text.starts_with(through)) {
    const std::string_view axis = text.substr(through.size());
    const std::size_t which = axes.find(axis);
    if (axis.size() != 1 || which == std::string_view::npos) return std::nullopt;
    return KeepPercolating{which};
  }
  std::uint64_t count = 0;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, count);
  if (error != std::errc() || read != end || count == 0) return std::nullopt;
  return KeepLargest{count};
}

}  // namespace certet
