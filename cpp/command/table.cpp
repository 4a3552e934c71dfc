#include "table.hpp"

#include <algorithm>
#include <cmath>

namespace certet::command {

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), 1, ',');
  return digits;
}

std::string bytes(std::uint64_t count) {
  if (count < 10'000) return fmt::format("{} bytes", count);
  double size = static_cast<double>(count) / 1024;
  for (const char* unit : {"KiB", "MiB", "GiB"}) {
    if (size < 1000) return fmt::format("{:.3g} {}", size, unit);
    size /= 1024;
  }
  return fmt::format("{:.3g} TiB", size);
}

void add_histogram(Lines& lines, const Quality& quality) {
  const auto& bins = quality.histogram;
  const std::uint64_t most = *std::max_element(bins.begin(), bins.end());
  std::uint64_t all = 0;
  for (const std::uint64_t bin : bins) all += bin;
  if (most == 0) return;
  for (std::size_t b = 0; b < bins.size(); ++b) {
    if (bins[b] == 0) continue;
    const double share = static_cast<double>(bins[b]) / static_cast<double>(most);
    lines.add("", "{:>3}-{:<3}° {:>6.2f} % {}", 5 * b, 5 * b + 5,
              100.0 * static_cast<double>(bins[b]) / static_cast<double>(all),
              std::string(static_cast<std::size_t>(std::lround(40 * share)), '#'));
  }
}

void add_angles(Lines& lines, const Quality& quality) {
  lines.add("dihedral", "{:.3f}° to {:.3f}°", quality.min_dihedral, quality.max_dihedral);
}

}  // namespace certet::command
