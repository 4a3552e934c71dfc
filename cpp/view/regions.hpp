#pragma once
/// \file
/// The regions of a mesh: its labels.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "certet/formats.hpp"
#include "palette.hpp"

namespace certet::view {

struct MeasuredRegion {
  std::int32_t label;
  std::uint64_t tets;
  double volume;  ///< signed sum, in world units cubed
};

/// By growing label; a mesh without labels is one region with the label 0.
class Regions {
 public:
  explicit Regions(const FileMesh& mesh);

  [[nodiscard]] const std::vector<MeasuredRegion>& all() const { return regions_; }
  /// The place of a tetrahedron's region among all.
  [[nodiscard]] std::size_t place(const FileMesh& mesh, std::uint64_t tet) const;
  /// The colour of the region at a place: of up to eight regions each has a hue of its own; of
  /// more, those that touch have the same only where they must.
  [[nodiscard]] const Rgb& color(std::size_t place) const { return colors_[place]; }
  /// The place of a label among all.
  [[nodiscard]] std::size_t place(std::int32_t label) const { return find(label); }

 private:
  [[nodiscard]] std::size_t find(std::int32_t label) const;

  std::vector<MeasuredRegion> regions_;
  std::vector<Rgb> colors_;
};

}  // namespace certet::view
