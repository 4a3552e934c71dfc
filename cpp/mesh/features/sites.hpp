#pragma once
/// \file
/// Where vertices may be, and the nearest such place.

#include <cstdint>
#include <vector>

#include "curve.hpp"
#include "zone.hpp"

namespace certet::features {

enum class Role : std::uint8_t {
  inside,  ///< anywhere
  face,    ///< on a patch
  curve,   ///< on a curve
  fixed,
};

struct Site {
  Role role = Role::fixed;
  std::uint32_t which = none;  ///< patch or curve
};

/// The patches of a surface.
class Patches {
 public:
  explicit Patches(const Features& features);
  /// That of the nearest triangle.
  [[nodiscard]] std::uint32_t at(const Vector& point) const;
  [[nodiscard]] Vector nearest(std::uint32_t patch, const Vector& point) const;
  /// Of the nearest triangle of a patch, of length 1.
  [[nodiscard]] Vector normal(std::uint32_t patch, const Vector& point) const;

 private:
  std::vector<std::uint32_t> of_;
  distance::TriangleTree all_;
  std::vector<distance::TriangleTree> each_;
};

/// Of all vertices of a zone.
class Sites {
 public:
  Sites(const Zone& zone, const Patches& patches, const std::vector<Curve>& curves);

  [[nodiscard]] const Site& operator[](Number v) const { return sites_[v]; }
  void set(Number v, Site site) { sites_[v] = site; }
  /// The place nearest to a point at which a vertex may be.
  [[nodiscard]] Coord3 onto(const Site& site, const Vector& point) const;
  /// What is left of a direction, at a place.
  [[nodiscard]] Vector part_of(const Site& site, const Vector& direction,
                               const Vector& place) const;
  [[nodiscard]] const Patches& patches() const { return patches_; }
  [[nodiscard]] const std::vector<Curve>& curves() const { return curves_; }

 private:
  const Patches& patches_;
  const std::vector<Curve>& curves_;
  std::vector<Site> sites_;
};

}  // namespace certet::features
