#pragma once
/// \file
/// The tetrahedra around a vertex, as a move of it changes them.
///
/// Angles are told by the squares of their cosines: the worst one, nearest to 0° or to 180°, has
/// the greatest.  Positions are whole numbers of steps and tetrahedra less than 2^19 wide, so that
/// edges and normals of faces are exact in doubles; products of these are rounded, by less than
/// `rounding` of a squared cosine and `rounding_volume` of a sixfold volume.  What is accepted is
/// beyond its bar by more than that, so that it holds of the whole numbers.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/domain.hpp"
#include "vector.hpp"

namespace certet::optimising {

inline constexpr double rounding = 1e-12;
inline constexpr double rounding_volume = 1 << 12;

/// Squares of cosines that the angles up to 90° and those above must stay below.
struct Bars {
  double acute, obtuse;
};

/// A tetrahedron, by the edges from the vertex to the others, and what a move of the vertex
/// leaves alone: the face across from it.
struct Spoke {
  std::array<Vector, 3> edges;
  Vector across;  ///< inward normal of that face, as long as twice its area
  double worst;   ///< greatest squared cosine of its angles
  std::uint64_t tet;  ///< its number

  /// Whether it is positive and below the bars once the vertex has moved.
  [[nodiscard]] bool keeps(const Vector& by, const Bars& bars) const;
  /// The greatest squared cosine of its angles once the vertex has moved.
  [[nodiscard]] double worst_after(const Vector& by) const;
  /// Puts the gradients, by the place of the vertex, of all squared cosines from `least` on
  /// behind `out`.
  void gradients(double least, std::vector<Vector>& out) const;
};

class Star {
 public:
  void clear() { spokes_.clear(); }
  void add(std::uint64_t tet, const TetCorners& corners, std::size_t vertex, double worst);
  /// Finds the worst angle of the one that was added last.
  void measure_last() { spokes_.back().worst = spokes_.back().worst_after({0, 0, 0}); }

  [[nodiscard]] std::span<const Spoke> spokes() const { return spokes_; }
  /// Moves the vertex and finds the worst angles, in single precision.
  void move(const Vector& by);
  /// The greatest squared cosine of all.
  [[nodiscard]] double worst() const;
  /// Whether all tetrahedra stay positive and come below the bars.  Looks first at those that
  /// did not the last time.
  [[nodiscard]] bool keeps(const Vector& by, const Bars& bars);

 private:
  std::vector<Spoke> spokes_;
};

}  // namespace certet::optimising
