#pragma once
/// \file
/// What the engine asks of the shape to be meshed: where the solid is, what it is
/// made of, where two materials part, and where it is cut off.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "certet/border.hpp"
#include "certet/lattice/coord3.hpp"
#include "certet/lattice/sign.hpp"

namespace certet {

/// What is at a point: 0 is outside, 1, 2, … are the materials of a domain.
using Material = std::int32_t;

/// An axis-aligned box of lattice points, both ends included, in lattice units.
struct LatticeBox {
  Coord3 low, high;
};

/// What is known of all points in a box at once.
enum class Extent { inside, outside, mixed };

/// An edge of the lattice whose ends are of different materials, in lattice units, from the
/// greater material to the lesser.
struct PartedEdge {
  Coord3 first, last;
  Material of_last = 0;   ///< what is at `last`, and not at `first`
  Material of_first = 1;  ///< what is at `first`; 0: not the outside, whatever it is
};

/// The corners of a tetrahedron, in steps.
using TetCorners = std::array<Coord3, 4>;

/// A shape, which divides space into the outside and one material or several.  The
/// engine speaks to it in lattice coordinates only; a domain that lives in world
/// coordinates keeps the `Frame` it was made with.
///
/// All materials together are the solid, of which the first three functions tell.
/// They are all that a solid of one material has to answer.  One of several
/// materials gives them `labels` and answers `row_materials` and `materials_at`
/// too, so that Sign::minus is where the material is 0; the rest has defaults that
/// ask these.
///
/// All calls are const, may come from several threads at once, and must give
/// the same answer for the same point every time.  What they throw ends the run.
class Domain {
 public:
  virtual ~Domain() = default;

  /// Signs of the lattice points first, first + (2,0,0), first + (4,0,0), …
  /// in lattice units; one for each element of `out`.
  virtual void row(Coord3 first, std::span<Sign> out) const = 0;

  /// Signs of arbitrary positions, in steps.  `out` is as long as `positions`.
  virtual void at(std::span<const Coord3> positions, std::span<Sign> out) const = 0;

  /// How many positions the domain likes to be asked for at once: more, where each call takes
  /// long whatever it asks for.  No answer depends on what else is asked.
  [[nodiscard]] virtual std::size_t batch() const { return 256; }

  /// A bound over a box; `mixed` says nothing and is always right.
  [[nodiscard]] virtual Extent extent(const LatticeBox& box) const {
    static_cast<void>(box);
    return Extent::mixed;
  }

  /// Whether the even points of the lattice alone tell what hangs together: then a method
  /// that keeps pieces takes an odd point for outside that would join several groups of
  /// its even neighbours (`VoxelSigns` of coq/Certificate.v).
  [[nodiscard]] virtual bool even_points_tell_pieces() const { return false; }

  /// What files call the materials: that of material m is labels()[m - 1].  No two are the
  /// same, and they stay where they are as long as the domain does.  None: the only
  /// material is 1, and it has no label.
  [[nodiscard]] virtual std::span<const std::int32_t> labels() const { return {}; }

  /// Materials of the points that `row` gives the signs of.  By default 1 where
  /// the sign is not minus.
  virtual void row_materials(Coord3 first, std::span<Material> out) const;

  /// Materials of arbitrary positions, in steps.  `out` is as long as `positions`.
  /// By default 1 where the sign is not minus.
  virtual void materials_at(std::span<const Coord3> positions, std::span<Material> out) const;

  /// The material of all points in a box, where it is known that they have the same.
  /// By default what `extent` says, of a solid of one material.
  [[nodiscard]] virtual std::optional<Material> material_of(const LatticeBox& box) const;

  /// Where two materials part: for each edge a number of steps from `first`, at
  /// least 0 and less than 2^step_bits, at which the material of `last` begins.
  ///
  /// By default by bisection, to one step: each position is taken for a part of the
  /// side of `last` exactly if it has that one's material, so that a third material
  /// in between goes to `first`.  Where `last` is outside, the search ends early at
  /// a position on the surface (`BisectOnEdge` of coq/Certificate.v).  An answer
  /// depends on its own edge alone.
  virtual void part(std::span<const PartedEdge> edges, std::span<std::uint16_t> out) const;

  /// Materials of tetrahedra of this domain's mesh.  `out` is as long as `tets`.  The
  /// engine asks only where there are several.  By default 1 for a solid of one material; else the material at the centroid
  /// (rounded down to steps) or, where that is outside, at the corner nearest to it
  /// that is not; of equally near ones, at the first.
  virtual void materials_of(std::span<const TetCorners> tets, std::span<Material> out) const;

  /// The boxes at whose faces the shape is cut off instead of having a surface of
  /// its own.  They hold all of the solid, and stay where they are as long as the
  /// domain does.
  [[nodiscard]] virtual std::span<const BorderBox> border() const { return {}; }
};

}  // namespace certet
