#pragma once
/// \file
/// Solids that have a name.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certet/bounds.hpp"
#include "certet/lattice.hpp"
#include "certet/pieces.hpp"
#include "certet/placed_domain.hpp"
#include "certet/solid.hpp"

namespace certet {

/// A named solid around the origin of the world, in world units:
///
///     sphere:R               a ball of radius R
///     torus:R,r              a tube of radius r around a ring of radius R > r about z
///     box:a,b,c              edges of lengths a, b and c along x, y and z
///     cylinder:R,H           radius R, height H along z
///     gyroid:PERIOD,T[,SIDE] a wall along the gyroid of this period, in a cube of
///                            SIDE (two periods).  It is at least T thick, and up
///                            to 1.23 T where T is small.
///     primitive, diamond, iwp, neovius:PERIOD,T[,SIDE]
///                            walls along Schwarz' P and D, Schoen's I-WP and
///                            Neovius' surface, at least T thick
///     struts:CELL,R[,SIDE]   round bars of radius R along the edges of cubic cells,
///                            in a cube of SIDE (two cells)
///
/// Those without an end, from the gyroid on, have functions that are no more than the
/// distance; all others are signed distances to the surface.
class ShapeDomain final : public PlacedDomain {
 public:
  /// Within `bounds`, if there are any, which cut the solid off.  `size` and
  /// `margin` are those of `lattice_around`, around the solid's bounds.
  /// \throws Error `bad_option` (a shape that does not exist, or numbers that do
  /// not make one), and as `lattice_around`.
  ShapeDomain(const std::string& shape, const std::optional<Bounds>& bounds, double size,
              std::int32_t margin);
  /// On a lattice that holds the solid.
  ShapeDomain(const std::string& shape, const std::optional<Bounds>& bounds,
              const PlacedLattice& around);

  [[nodiscard]] const Frame& frame() const override { return around_.frame; }
  [[nodiscard]] const Lattice& lattice() const override { return around_.lattice; }
  [[nodiscard]] double longest_side() const override { return certet::longest_side(bounds_); }
  /// The box around the solid, exact but where `bounds` cut it.
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  /// Of the box that a solid without an end fills a part of, in world units cubed.
  [[nodiscard]] std::optional<double> room() const { return room_; }
  /// In world units cubed, where there is a formula: for all that have an end, unless
  /// bounds cut the solid off.
  [[nodiscard]] std::optional<double> volume() const { return volume_; }
  /// How many it has, where that is known: one where there is a formula for the volume.
  [[nodiscard]] std::optional<PieceBounds> pieces() const {
    return volume_ ? std::optional(PieceBounds{1, 1}) : std::nullopt;
  }

  void row(Coord3 first, std::span<Sign> out) const override { solid_->row(first, out); }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    solid_->at(positions, out);
  }
  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    return solid_->extent(box);
  }
  [[nodiscard]] std::span<const BorderBox> border() const override { return border_; }
  /// Of boxes and cylinders.
  [[nodiscard]] std::vector<TriangleCorners> facets() const override { return facets_; }

 private:
  Bounds bounds_;
  std::vector<TriangleCorners> facets_;
  std::optional<double> volume_, room_;
  PlacedLattice around_;
  std::vector<BorderBox> border_;  ///< the bounds, if they cut the solid off
  std::unique_ptr<Domain> solid_;
};

/// Whether a text begins as that of a shape does: `sphere:…`.
bool is_shape(const std::string& text);

/// The same solid, to be put on a lattice with others.
/// \throws Error `bad_option` as `ShapeDomain`.
Solid shape_solid(const std::string& shape, const std::optional<Bounds>& bounds = {});

}  // namespace certet
