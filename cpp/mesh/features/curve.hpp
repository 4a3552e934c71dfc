#pragma once
/// \file
/// Sharp edges one behind the other, from corner to corner or around.

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "certet/features.hpp"
#include "mesh/distance/triangle_tree.hpp"
#include "vectors.hpp"

namespace certet::features {

inline constexpr double long_edge = 2.0 * steps;
inline constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

inline Vector in_doubles(Coord3 p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}
/// The nearest whole step.
inline Coord3 in_steps(const Vector& p) { return optimising::moved({0, 0, 0}, p); }

/// Where a curve is nearest to something.
struct CurvePoint {
  Vector place;
  double at;    ///< length from the curve's beginning
  double away;  ///< distance
};

class Curve {
 public:
  /// Points one behind the other; of a loop the last is the first.  `left` and `right` are the
  /// patches beside it, and `first` and `last` the numbers of the corners at which it ends.
  Curve(std::vector<Vector> points, std::uint32_t left, std::uint32_t right, std::uint32_t first,
        std::uint32_t last);

  [[nodiscard]] bool is_loop() const { return first == none; }
  [[nodiscard]] double length() const { return at_.back(); }
  [[nodiscard]] CurvePoint nearest(const Vector& point) const;
  [[nodiscard]] Vector place(double at) const;
  /// Of length 1.
  [[nodiscard]] Vector direction(double at) const;
  [[nodiscard]] std::span<const Vector> points() const { return points_; }
  /// Lengths from the beginning to each of the points.
  [[nodiscard]] std::span<const double> lengths() const { return at_; }

  std::uint32_t left, right, first, last;

 private:
  [[nodiscard]] std::size_t segment(double at) const;

  std::vector<Vector> points_;
  std::vector<double> at_;
  distance::TriangleTree tree_;
};

/// All sharp edges, in curves.
std::vector<Curve> curves_of(const Features& features);

}  // namespace certet::features
