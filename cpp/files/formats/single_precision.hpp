#pragma once
/// \file
/// What is left of a surface in numbers of 32 bits.

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "certet/frame.hpp"

namespace certet::formats {

using Single3 = std::array<float, 3>;
using Triangle3 = std::array<Point3, 3>;

/// To the nearest; beyond what 32 bits hold, infinity.
Single3 single(const Point3& point);

/// The normal of a triangle, of length 1; zero where it has no area.
Point3 normal_of(const Triangle3& triangle);

/// Whether single precision holds a surface.  It does where points that are distinct
/// stay distinct and finite, and where each triangle that has an area keeps it, and its
/// normal but for 4.5 degrees: less than half of the least angle between two faces of a
/// tetrahedron that any theorem gives, so that two triangles of one tetrahedron cannot
/// be folded upon each other.
class SinglePrecisionCheck {
 public:
  void add(const Triangle3& triangle);
  /// All of them at once.  Those that are not finite to begin with are left out.
  void add(std::span<const Point3> points);

  /// What would be lost, in words; empty where nothing is.
  [[nodiscard]] std::string loss() const;

 private:
  std::uint64_t triangles_ = 0, turned_ = 0;
  std::uint64_t points_ = 0, infinite_ = 0, joined_ = 0;
};

}  // namespace certet::formats
