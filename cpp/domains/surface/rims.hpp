#pragma once
/// \file
/// What is missing from the winding numbers of a surface that is open.
///
/// The generalised winding number around a point (Jacobson, Kavan and Sorkine-Hornung
/// 2013) is the sum of the solid angles of all triangles, each with its sign, as a part
/// of the sphere.  It is a whole number and a rest.  The number: how often the ray from
/// the point along x leaves the surface, less how often it enters.  The rest: the solid
/// angles between the edges at which the surface ends and the other end of the x axis.
/// For the cone over these edges to there closes the surface, and no such ray meets it.
///
/// So where a surface has few holes, few edges are looked at; and pieces of them that
/// are far away, and that the ray does not meet, are taken for one edge and an area, as
/// Barill, Dickson, Schmidt, Levin and Jacobson (2018) do with triangles.

#include <vector>

#include "exact.hpp"
#include "rim_tree.hpp"

namespace certet {

class Rims {
 public:
  explicit Rims(const std::vector<RimLoop>& loops) : tree_(loops) {}

  /// The rest, of a point in steps that was moved; NaN of one on a rim.  It is always the
  /// same sum in the same order, of numbers that are the same on every machine.
  [[nodiscard]] double rest(Coord3 p, exact::Nudge nudge) const;

  /// How much winding numbers may differ within a ball, in steps, that the surface
  /// does not meet, from that at its centre: by the law of Biot and Savart.  More than
  /// `enough` is not told from infinity.
  [[nodiscard]] double variation(Coord3 centre, double radius, double enough) const;

  /// Whether the ray along x from some point of a box, in steps, may meet a rim.
  [[nodiscard]] bool may_be_ahead(const IntegerBox& box) const;

  [[nodiscard]] std::uint64_t bytes() const;

 private:
  RimTree tree_;
};

}  // namespace certet
