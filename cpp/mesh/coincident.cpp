#include <algorithm>
#include <bit>
#include <cmath>

#include "certet/placed_quality.hpp"
#include "groups.hpp"

namespace certet {
namespace {

/// Mixes a point's coordinates to 64 bits.
std::uint64_t hash(const Point3& point) {
  std::uint64_t mixed = 0;
  for (const double coordinate : point) {
    // Adding zero makes one of the two zeros.
    mixed ^= std::bit_cast<std::uint64_t>(coordinate + 0.0);
    mixed *= 0x9e3779b97f4a7c15;
    mixed ^= mixed >> 32;
  }
  return mixed;
}

}  // namespace

std::uint64_t count_coincident(std::span<const Point3> points) {
  if (points.empty()) return 0;
  const std::size_t groups = points.size();
  core::Groups<std::uint64_t> by_hash(groups);
  const auto group_of = [groups](const Point3& p) { return hash(p) % groups; };
  for (const Point3& p : points)
    if (is_finite(p)) by_hash.count(group_of(p));
  by_hash.lay_out();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_finite(points[i])) by_hash.place(group_of(points[i]), i);

  std::uint64_t duplicates = 0;
  const auto same = [points](std::uint64_t a, std::uint64_t b) { return points[a] == points[b]; };
  for (std::size_t i = 0; i < groups; ++i) {
    const std::span<std::uint64_t> group = by_hash[i];
    if (group.size() < 2) continue;
    std::sort(group.begin(), group.end(),
              [points](std::uint64_t a, std::uint64_t b) { return points[a] < points[b]; });
    core::for_runs(group, same,
                      [&](std::span<std::uint64_t> run) { duplicates += run.size() - 1; });
  }
  return duplicates;
}

}  // namespace certet
