#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "certet/error.hpp"
#include "certet/structured_tet.hpp"
#include "certet/expression.hpp"
#include "formula.hpp"

namespace certet {
namespace {

double checked_size(const Bounds& bounds, double size) {
  double longest = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const double side = bounds.high[a] - bounds.low[a];
    if (!std::isfinite(side) || side <= 0)
      throw Error(ErrorCode::bad_option,
                  "the bounds must be finite, and each low one less than the high one");
    longest = std::max(longest, side);
  }
  const double chosen = size == 0 ? longest / 64 : size;
  if (!std::isfinite(chosen) || chosen <= 0)
    throw Error(ErrorCode::bad_option, "the size must be a positive number");
  return chosen;
}

/// Even cells, so that the even point (0,0,0) is in the middle.
std::int32_t cells_along(double side, double size, std::int32_t margin) {
  return checked_cells(2 * (std::ceil(side / (2 * size)) + margin));
}

/// How far a point is beyond the bounds along one axis; negative within.
double beyond(const Bounds& bounds, const Point3& point) {
  double most = bounds.low[0] - point[0];
  for (std::size_t a = 0; a < 3; ++a)
    most = std::max({most, bounds.low[a] - point[a], point[a] - bounds.high[a]});
  return most;
}

}  // namespace

struct ExpressionDomain::State {
  Bounds bounds;
  Frame frame;
  Lattice lattice;
  FormulaPool formulas;

  /// The level function of the formula's solid cut by the bounds.
  Sign sign(FormulaPool::Loan& formula, Coord3 position) const {
    const Point3 point = frame.world(position);
    const double outer = beyond(bounds, point);
    if (outer > 0) return Sign::minus;
    const double inner = formula(point);
    return std::isnan(inner) ? Sign::minus : sign_of_level(std::max(inner, outer));
  }
};

ExpressionDomain::ExpressionDomain(std::string formula, const Bounds& bounds, double size,
                                   std::int32_t margin)
    : state_(new State{bounds, {}, {}, FormulaPool(std::move(formula))}) {
  if (margin < 1) throw Error(ErrorCode::bad_option, "the margin must be at least 1");
  Frame& frame = state_->frame;
  Lattice& lattice = state_->lattice;
  frame.size = checked_size(bounds, size);
  for (std::size_t a = 0; a < 3; ++a) {
    frame.origin[a] = 0.5 * (bounds.low[a] + bounds.high[a]);
    lattice.cells[a] = cells_along(bounds.high[a] - bounds.low[a], frame.size, margin);
  }
  lattice.origin = {-lattice.cells[0], -lattice.cells[1], -lattice.cells[2]};
}

ExpressionDomain::~ExpressionDomain() = default;

bool can_read_expressions() { return true; }

const Frame& ExpressionDomain::frame() const { return state_->frame; }
const Lattice& ExpressionDomain::lattice() const { return state_->lattice; }

void ExpressionDomain::row(Coord3 first, std::span<Sign> out) const {
  FormulaPool::Loan formula(state_->formulas);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = state_->sign(
        formula, steps * (first + Coord3{2 * static_cast<std::int32_t>(i), 0, 0}));
}

void ExpressionDomain::at(std::span<const Coord3> positions, std::span<Sign> out) const {
  FormulaPool::Loan formula(state_->formulas);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = state_->sign(formula, positions[i]);
}

Extent ExpressionDomain::extent(const LatticeBox& box) const {
  const Point3 low = state_->frame.world(steps * box.low);
  const Point3 high = state_->frame.world(steps * box.high);
  for (std::size_t a = 0; a < 3; ++a)
    if (high[a] < state_->bounds.low[a] || low[a] > state_->bounds.high[a])
      return Extent::outside;
  return Extent::mixed;
}

}  // namespace certet
