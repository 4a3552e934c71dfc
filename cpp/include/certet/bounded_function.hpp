#pragma once
/// \file
/// A function of world coordinates within bounds, as a domain that knows where it lies.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "certet/border.hpp"
#include "certet/bounds.hpp"
#include "certet/function_domain.hpp"
#include "certet/lattice.hpp"
#include "certet/placed_domain.hpp"
#include "certet/solid.hpp"

namespace certet {

/// How far a point is beyond bounds along one axis, in world units; negative within.
inline double beyond(const Bounds& bounds, const Point3& point) {
  double most = bounds.low[0] - point[0];
  for (std::size_t a = 0; a < 3; ++a)
    most = std::max({most, bounds.low[a] - point[a], point[a] - bounds.high[a]});
  return most;
}

/// The points within bounds where a function is negative; where it is 0 is the
/// surface, and NaN counts as outside.  `Function` is callable as double(Point3) with
/// a point of the world, const, from several threads at once.
///
///     const BoundedFunction ball([](Point3 p) { return …; }, {{-1, -1, -1}, {1, 1, 1}}, 0.1);
template <class Function>
class BoundedFunction final : public PlacedDomain {
 public:
  /// `size` is the long edge of the lattice in world units (0: a 64th of the longest
  /// side of the bounds), `margin` the cells of the lattice around the bounds.
  /// \throws Error as `lattice_around`.
  BoundedFunction(Function function, const Bounds& bounds, double size = 0,
                  std::int32_t margin = 2)
      : BoundedFunction(std::move(function), bounds, lattice_around(bounds, size, margin)) {}
  /// On a lattice that holds the bounds.
  BoundedFunction(Function function, const Bounds& bounds, const PlacedLattice& around)
      : bounds_(bounds),
        around_(around),
        solid_(CutOff{std::move(function), bounds}, around_.frame),
        border_{BorderBox::along_frame(around_.frame, bounds.low, bounds.high)} {}

  [[nodiscard]] const Frame& frame() const override { return around_.frame; }
  [[nodiscard]] const Lattice& lattice() const override { return around_.lattice; }
  [[nodiscard]] double longest_side() const override { return certet::longest_side(bounds_); }

  void row(Coord3 first, std::span<Sign> out) const override { solid_.row(first, out); }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    solid_.at(positions, out);
  }

  /// Nothing is known but where the bounds end.  The axes are the world's, and rounding
  /// is monotone.
  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    const Point3 low = around_.frame.world(steps * box.low);
    const Point3 high = around_.frame.world(steps * box.high);
    for (std::size_t a = 0; a < 3; ++a)
      if (high[a] < bounds_.low[a] || low[a] > bounds_.high[a]) return Extent::outside;
    return Extent::mixed;
  }

  [[nodiscard]] std::span<const BorderBox> border() const override { return border_; }

 private:
  struct CutOff {
    Function function;
    Bounds bounds;

    double operator()(const Point3& point) const {
      const double value = function(point);
      return std::isnan(value) ? value : std::max(value, beyond(bounds, point));
    }
  };

  Bounds bounds_;
  PlacedLattice around_;
  FunctionDomain<CutOff> solid_;
  std::array<BorderBox, 1> border_;
};

/// The same solid, to be put on a lattice with others.
template <class Function>
Solid function_solid(Function function, const Bounds& bounds) {
  return {bounds, [function = std::move(function), bounds](const PlacedLattice& around) {
            return std::make_shared<BoundedFunction<Function>>(function, bounds, around);
          }};
}

}  // namespace certet
