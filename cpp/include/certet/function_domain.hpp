#pragma once
/// \file
/// Domains given by a function of world coordinates.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "certet/domain.hpp"
#include "certet/frame.hpp"

namespace certet {

/// The points where a function is negative; where it is 0 is the surface, and
/// NaN counts as outside.  `Function` is callable as double(Point3), const, from
/// several threads at once.
///
/// If it changes by no more than `lipschitz` per world unit (1 for a distance),
/// one value decides whole blocks of the lattice, which are not sampled then.
///
///     const Frame frame{.size = 0.1};
///     const FunctionDomain ball([](Point3 p) { return …; }, frame);
template <class Function>
class FunctionDomain final : public Domain {
 public:
  /// `lipschitz` holds to within a part in 2^40 of itself, values of the function
  /// to within as small a part of themselves and of `lipschitz` times the
  /// coordinates.  Infinity: nothing is known.
  FunctionDomain(Function function, const Frame& frame,
                 double lipschitz = std::numeric_limits<double>::infinity())
      : function_(std::move(function)), frame_(frame), lipschitz_(lipschitz) {}

  [[nodiscard]] const Frame& frame() const { return frame_; }

  void row(Coord3 first, std::span<Sign> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = sign(steps * (first + Coord3{2 * static_cast<std::int32_t>(i), 0, 0}));
  }

  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = sign(positions[i]);
  }

  /// By the value at the centre.
  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    if (!std::isfinite(lipschitz_)) return Extent::mixed;
    const Point3 centre = frame_.world(steps / 2 * (box.low + box.high));
    const Coord3 diagonal = box.high - box.low;
    const double radius =
        0.25 * frame_.size * std::hypot(double(diagonal.x), double(diagonal.y), double(diagonal.z));
    const double value = function_(centre);
    const double far = std::abs(centre[0]) + std::abs(centre[1]) + std::abs(centre[2]) + radius;
    const double rounding = 0x1p-40 * (std::abs(value) + lipschitz_ * far);
    const double reach = lipschitz_ * radius + rounding;
    if (value > reach) return Extent::outside;
    return value < -reach ? Extent::inside : Extent::mixed;
  }

 private:
  [[nodiscard]] Sign sign(Coord3 position) const {
    return sign_of_level(function_(frame_.world(position)));
  }

  Function function_;
  Frame frame_;
  double lipschitz_;
};

}  // namespace certet
