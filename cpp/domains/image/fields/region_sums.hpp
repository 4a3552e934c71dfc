#pragma once
/// \file
/// How large regions are, and where they meet.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fields/field_tile.hpp"

namespace certet::fields {

/// Volumes of materials, and areas of the surfaces between two of them.  Sums of whole
/// numbers, so that the order of what is added makes no difference.
class RegionSums {
 public:
  /// A voxel's volume, and the area of its face.
  static constexpr std::int64_t unit = std::int64_t{8} * field_one;

  /// Between `low` and `high`, of which `low` is the lower material.
  struct Area {
    Material low, high;
    std::int64_t area;
  };

  explicit RegionSums(std::size_t materials) : volumes_(materials, 0) {}

  void add_volume(Material material, std::int64_t volume) {
    volumes_[static_cast<std::size_t>(material)] += volume;
  }
  /// Between two different materials; those of neighbouring points are mostly the same.
  void add_area(Material one, Material other, std::int64_t area) {
    const Material low = one < other ? one : other, high = one < other ? other : one;
    if (areas_.empty() || areas_.back().low != low || areas_.back().high != high)
      areas_.push_back({low, high, 0});
    areas_.back().area += area;
  }
  void add(const RegionSums& other);

  /// Makes one of all areas between the same two, and sorts them.
  void merge_areas();

  [[nodiscard]] const std::vector<std::int64_t>& volumes() const { return volumes_; }
  [[nodiscard]] const std::vector<Area>& areas() const { return areas_; }

 private:
  std::vector<std::int64_t> volumes_;
  std::vector<Area> areas_;
};

}  // namespace certet::fields
