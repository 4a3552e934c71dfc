#pragma once
/// \file
/// The triangles that a line along x may meet.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "exact.hpp"

namespace certet {

/// Triangles sorted into columns along x, of square cross section.
class TriangleColumns {
 public:
  /// Points in steps.
  TriangleColumns(std::vector<Coord3> points,
                  std::vector<std::array<std::uint32_t, 3>> triangles);

  /// Calls visit(triangle) for every triangle that, seen along x, may contain the
  /// point, and reaches as far as its x.
  template <class Visit>
  void for_each_number_ahead(Coord3 point, const Visit& visit) const {
    for (const Entry& entry : column(point)) {
      if (entry.high_x < point.x) return;  // nor do those behind it
      if (entry.covers(point)) visit(entry.triangle);
    }
  }

  /// The same with visit(corners).
  template <class Visit>
  void for_each_ahead(Coord3 point, const Visit& visit) const {
    for_each_number_ahead(point, [&](std::uint32_t triangle) { visit(corners(triangle)); });
  }

  /// How often the ray along x from a moved point leaves the solid, less how often it
  /// enters.
  [[nodiscard]] int crossings(Coord3 point, exact::Nudge nudge) const {
    int sum = 0;
    for_each_ahead(point, [&](const exact::Corners& t) {
      const int direction = exact::passing(t, point, nudge);
      if (direction != 0 && exact::ahead(t, exact::normal(t), direction, point, nudge))
        sum += direction;
    });
    return sum;
  }

  [[nodiscard]] exact::Corners corners(std::uint32_t triangle) const {
    const auto& numbers = triangles_[triangle];
    return {points_[numbers[0]], points_[numbers[1]], points_[numbers[2]]};
  }
  [[nodiscard]] std::uint32_t size() const {
    return static_cast<std::uint32_t>(triangles_.size());
  }
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  /// A triangle's bounding box, seen along x, and how far it reaches.
  struct Entry {
    std::int32_t high_x, low_y, high_y, low_z, high_z;
    std::uint32_t triangle;

    [[nodiscard]] bool covers(Coord3 point) const {
      return low_y <= point.y && point.y <= high_y && low_z <= point.z && point.z <= high_z;
    }
  };

  /// Those that reach farthest come first.
  [[nodiscard]] std::span<const Entry> column(Coord3 point) const {
    const std::int64_t j = std::int64_t{point.y} - low_y_, k = std::int64_t{point.z} - low_z_;
    if (j < 0 || k < 0 || (j >> shift_) >= across_y_ || (k >> shift_) >= across_z_) return {};
    const auto at = static_cast<std::size_t>((k >> shift_) * across_y_ + (j >> shift_));
    return {entries_.data() + begins_[at], begins_[at + 1] - begins_[at]};
  }

  [[nodiscard]] Entry entry(std::uint32_t triangle) const;
  void find_extent();
  void choose_width();
  void fill();
  template <class Visit>
  void for_each_column(const Entry& entry, const Visit& visit) const;

  std::vector<Coord3> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::int64_t low_y_ = 0, low_z_ = 0, high_y_ = 0, high_z_ = 0;
  int shift_ = 0;  ///< a column is 2^shift steps wide
  std::int64_t across_y_ = 0, across_z_ = 0;
  std::vector<std::size_t> begins_;
  std::vector<Entry> entries_;
};

}  // namespace certet
