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

/// The patches of a surface: what hangs together but for sharp edges.
class Patches {
 public:
  virtual ~Patches() = default;
  /// That of a vertex of the boundary.
  [[nodiscard]] virtual std::uint32_t at(std::uint64_t vertex, const Vector& place) const = 0;
  /// About the nearest point of a patch.
  [[nodiscard]] virtual Vector nearest(std::uint32_t patch, const Vector& point) const = 0;
  /// There, of length 1.
  [[nodiscard]] virtual Vector normal(std::uint32_t patch, const Vector& point) const = 0;
};

/// Of triangles.
class TrianglePatches final : public Patches {
 public:
  explicit TrianglePatches(const Features& features);
  /// That of the nearest triangle.
  [[nodiscard]] std::uint32_t at(std::uint64_t vertex, const Vector& place) const override;
  [[nodiscard]] Vector nearest(std::uint32_t patch, const Vector& point) const override;
  /// Of the nearest triangle of a patch.
  [[nodiscard]] Vector normal(std::uint32_t patch, const Vector& point) const override;

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
