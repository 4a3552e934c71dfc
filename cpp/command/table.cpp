#include "table.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

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

void add_histogram(Lines& lines, const Quality& quality, std::size_t together) {
  constexpr std::size_t degrees = 5;  // of a bin
  std::vector<std::uint64_t> bins((quality.histogram.size() + together - 1) / together);
  std::uint64_t all = 0;
  for (std::size_t b = 0; b < quality.histogram.size(); ++b) {
    bins[b / together] += quality.histogram[b];
    all += quality.histogram[b];
  }
  const std::uint64_t most = *std::max_element(bins.begin(), bins.end());
  if (most == 0) return;
  for (std::size_t b = 0; b < bins.size(); ++b) {
    if (bins[b] == 0) continue;
    const double share = static_cast<double>(bins[b]) / static_cast<double>(most);
    lines.add("", "{:>3}-{:<3}° {:>6.2f} % {}", degrees * together * b,
              degrees * together * (b + 1),
              100.0 * static_cast<double>(bins[b]) / static_cast<double>(all),
              std::string(static_cast<std::size_t>(std::lround(40 * share)), '#'));
  }
}

void add_angles(Lines& lines, const Quality& quality) {
  lines.add("dihedral", "{:.3f}° to {:.3f}°", quality.min_dihedral, quality.max_dihedral);
}

}  // namespace certet::command
