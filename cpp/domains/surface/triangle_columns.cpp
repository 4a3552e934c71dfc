#include "triangle_columns.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace certet {

TriangleColumns::TriangleColumns(std::vector<Coord3> points,
                                 std::vector<std::array<std::uint32_t, 3>> triangles)
    : points_(std::move(points)), triangles_(std::move(triangles)) {
  find_extent();
  choose_width();
  fill();
}

TriangleColumns::Entry TriangleColumns::entry(std::uint32_t triangle) const {
  const auto [a, b, c] = corners(triangle);
  const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
  const auto [low_z, high_z] = std::minmax({a.z, b.z, c.z});
  return {std::max({a.x, b.x, c.x}), low_y, high_y, low_z, high_z, triangle};
}

void TriangleColumns::find_extent() {
  low_y_ = low_z_ = std::numeric_limits<std::int64_t>::max();
  high_y_ = high_z_ = std::numeric_limits<std::int64_t>::min();
  for (std::uint32_t t = 0; t < size(); ++t) {
    const Entry box = entry(t);
    low_y_ = std::min<std::int64_t>(low_y_, box.low_y);
    low_z_ = std::min<std::int64_t>(low_z_, box.low_z);
    high_y_ = std::max<std::int64_t>(high_y_, box.high_y);
    high_z_ = std::max<std::int64_t>(high_z_, box.high_z);
  }
}

/// The narrowest columns of which there are no more than triangles, or so, and
/// in which a triangle lies in few on average.
void TriangleColumns::choose_width() {
  const std::int64_t most_columns = 4096 + std::int64_t{size()};
  const std::int64_t most_entries = 65536 + 6 * std::int64_t{size()};
  for (shift_ = 0;; ++shift_) {
    across_y_ = ((high_y_ - low_y_) >> shift_) + 1;
    across_z_ = ((high_z_ - low_z_) >> shift_) + 1;
    if (across_y_ > most_columns || across_y_ * across_z_ > most_columns) continue;
    std::int64_t entries = 0;
    for (std::uint32_t t = 0; t < size() && entries <= most_entries; ++t) {
      const Entry box = entry(t);
      entries += (((box.high_y - low_y_) >> shift_) - ((box.low_y - low_y_) >> shift_) + 1) *
                 (((box.high_z - low_z_) >> shift_) - ((box.low_z - low_z_) >> shift_) + 1);
    }
    if (entries <= most_entries) return;
  }
}

template <class Visit>
void TriangleColumns::for_each_column(const Entry& entry, const Visit& visit) const {
  for (std::int64_t k = (entry.low_z - low_z_) >> shift_; k <= (entry.high_z - low_z_) >> shift_; ++k)
    for (std::int64_t j = (entry.low_y - low_y_) >> shift_; j <= (entry.high_y - low_y_) >> shift_;
         ++j)
      visit(static_cast<std::size_t>(k * across_y_ + j));
}

void TriangleColumns::fill() {
  begins_.assign(static_cast<std::size_t>(across_y_ * across_z_) + 1, 0);
  for (std::uint32_t t = 0; t < size(); ++t)
    for_each_column(entry(t), [&](std::size_t column) { ++begins_[column + 1]; });
  for (std::size_t c = 1; c < begins_.size(); ++c) begins_[c] += begins_[c - 1];
  entries_.resize(begins_.back());
  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
  for (std::uint32_t t = 0; t < size(); ++t) {
    const Entry box = entry(t);
    for_each_column(box, [&](std::size_t column) { entries_[next[column]++] = box; });
  }
  for (std::size_t c = 0; c + 1 < begins_.size(); ++c)
    std::sort(entries_.data() + begins_[c], entries_.data() + begins_[c + 1],
              [](const Entry& a, const Entry& b) {
                return std::pair(a.high_x, a.triangle) > std::pair(b.high_x, b.triangle);
              });
}

std::uint64_t TriangleColumns::bytes() const {
  return points_.size() * sizeof(Coord3) + triangles_.size() * sizeof(triangles_[0]) +
         begins_.size() * sizeof(begins_[0]) + entries_.size() * sizeof(Entry);
}

}  // namespace certet
