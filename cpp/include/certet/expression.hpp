#pragma once
/// \file
/// Domains given by a formula.

#include <cstdint>
#include <memory>
#include <string>

#include "certet/domain.hpp"
#include "certet/frame.hpp"
#include "certet/stuffing.hpp"

namespace certet {

/// An axis-aligned box in world coordinates.
struct Bounds {
  Point3 low, high;
};

/// Whether formulas were built in.
bool can_read_expressions();

/// Where a formula in x, y, z (world coordinates) is negative, within bounds.
/// Beyond the bounds all is outside, which closes the solid there; where the
/// formula gives NaN is outside too.
///
/// The formula is muParser's: + - * / ^ and comparisons, c ? a : b, min max abs
/// sqrt exp log (natural) log10 sin cos tan asin acos atan sinh cosh tanh atan2,
/// and pow(a,b) floor ceil hypot(a,b,…) clamp(v,low,high), pi and e.
///
/// Evaluates in several threads at once, each with a parser of its own.
class ExpressionDomain final : public Domain {
 public:
  /// `size` is the long edge in world units; 0: a 64th of the longest side of
  /// the bounds.  Lattice point (0,0,0) is the centre of the bounds, the axes
  /// are the world's, and `margin` (at least 1) cells surround the bounds.
  /// \throws Error `bad_input` (a formula that cannot be read, with the position),
  /// `bad_option` (bounds, size, margin), `too_large` (coordinate range).
  ExpressionDomain(std::string formula, const Bounds& bounds, double size,
                   std::int32_t margin);
  ~ExpressionDomain() override;

  [[nodiscard]] const Frame& frame() const;
  [[nodiscard]] const Lattice& lattice() const;

  void row(Coord3 first, std::span<Sign> out) const override;
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override;
  [[nodiscard]] Extent extent(const LatticeBox& box) const override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace certet
