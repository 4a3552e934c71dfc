#pragma once
/// \file
/// What a patch of a surface covers, seen from far away.

#include <array>

#include "vectors.hpp"

namespace certet {

/// A symmetric matrix: xx, yy, zz, yz, zx, xy.
struct Symmetric {
  std::array<double, 6> entries{};

  /// Adds a share of the symmetric part of twice a bᵀ, halved.
  void add(const Point3& a, const Point3& b, double share) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      entries[i] += share * (a[i] * b[i]);
      entries[3 + i] += share * ((a[j] * b[k] + a[k] * b[j]) / 2);
    }
  }
  void add(const Symmetric& other) {
    for (std::size_t i = 0; i < 6; ++i) entries[i] += other.entries[i];
  }
  [[nodiscard]] double trace() const { return entries[0] + entries[1] + entries[2]; }
  [[nodiscard]] Point3 times(const Point3& v) const {
    const auto& [xx, yy, zz, yz, zx, xy] = entries;
    return {xx * v[0] + xy * v[1] + zx * v[2], xy * v[0] + yy * v[1] + yz * v[2],
            zx * v[0] + yz * v[1] + zz * v[2]};
  }
};

/// A patch's area, and how it lies around its centre: the solid angle that it covers is
/// expanded to the second order in how far its parts are from there, where their
/// distribution is taken to be the same for all directions that they face.
class AreaMoments {
 public:
  AreaMoments() = default;
  /// Of a triangle.
  AreaMoments(const Point3& a, const Point3& b, const Point3& c);

  /// Of two patches.
  [[nodiscard]] AreaMoments with(const AreaMoments& other) const;

  /// None of a patch without an area.
  [[nodiscard]] const Point3& centre() const { return centre_; }
  /// Without regard to where its parts face.
  [[nodiscard]] double area() const { return area_; }

  /// The solid angle seen from a point, positive where it sees the back; `away` is from
  /// there to the centre.
  [[nodiscard]] double solid_angle(const Point3& away) const;

 private:
  void add(const AreaMoments& part);

  double area_ = 0;
  Point3 centre_{0, 0, 0};  ///< of the area
  Point3 vector_{0, 0, 0};  ///< of the area
  Symmetric tilt_;          ///< sums over parts: area vector times the part's place
  Symmetric spread_;        ///< area times the place, squared
};

}  // namespace certet
