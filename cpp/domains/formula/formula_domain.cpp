#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "batch.hpp"
#include "certet/formula.hpp"
#include "parse.hpp"
#include "range.hpp"

namespace certet {
namespace {

/// How far a point is beyond the bounds along one axis; negative within.
NodeId record_beyond(const Bounds& bounds, Tape& tape) {
  const auto difference = [&tape](NodeId a, NodeId b) {
    return tape.add(Operation::subtract, a, b);
  };
  NodeId most = difference(tape.constant(bounds.low[0]), tape.variable(0));
  for (std::size_t a = 0; a < 3; ++a) {
    const NodeId at = tape.variable(a);
    most = tape.add(Operation::maximum, most, difference(tape.constant(bounds.low[a]), at));
    most = tape.add(Operation::maximum, most, difference(at, tape.constant(bounds.high[a])));
  }
  return most;
}

}  // namespace

struct FormulaDomain::State {
  /// The formula cut by the bounds is a formula again.
  struct CutFormula {
    CutFormula(const std::string& text, const Bounds& bounds)
        : within(parse(text, tape)),
          beyond(record_beyond(bounds, tape)),
          level(tape.add(Operation::maximum, within, beyond)) {}

    Tape tape;
    NodeId within, beyond;
    NodeId level;  ///< NaN where the formula is NaN, which is outside too
  };

  State(const std::string& text, const Bounds& bounds, const PlacedLattice& around)
      : formula(text, bounds),
        of_rows(formula.tape, formula.level, Batch::row),
        of_points(formula.tape, formula.level, Batch::points),
        frame(around.frame),
        lattice(around.lattice),
        border{BorderBox::along_frame(frame, bounds.low, bounds.high)},
        side(certet::longest_side(bounds)) {}

  CutFormula formula;
  BatchFormula of_rows, of_points;
  Frame frame;
  Lattice lattice;
  std::array<BorderBox, 1> border;
  double side;  ///< the longest of the bounds
};

namespace {

using Coordinates = std::array<double, batch_limit>;

void signs_of(const Coordinates& levels, std::span<Sign> out) {
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = sign_of_level(levels[i]);
}

}  // namespace

FormulaDomain::FormulaDomain(const std::string& formula, const Bounds& bounds, double size,
                                   std::int32_t margin)
    : FormulaDomain(formula, bounds, lattice_around(bounds, size, margin)) {}

FormulaDomain::FormulaDomain(const std::string& formula, const Bounds& bounds,
                             const PlacedLattice& around)
    : state_(new State(formula, bounds, around)) {}

FormulaDomain::~FormulaDomain() = default;

bool can_read_formulas() { return true; }

const Frame& FormulaDomain::frame() const { return state_->frame; }
const Lattice& FormulaDomain::lattice() const { return state_->lattice; }
std::span<const BorderBox> FormulaDomain::border() const { return state_->border; }
double FormulaDomain::longest_side() const { return state_->side; }

void FormulaDomain::row(Coord3 first, std::span<Sign> out) const {
  const State& state = *state_;
  BatchFormula::Workspace workspace(state.of_rows);
  const auto [x0, y, z] = state.frame.world(steps * first);
  Coordinates x, levels;
  while (!out.empty()) {
    const std::size_t count = std::min(out.size(), batch_limit);
    for (std::size_t i = 0; i < count; ++i)
      x[i] = state.frame.world(steps * (first + Coord3{2 * static_cast<std::int32_t>(i), 0, 0}))[0];
    state.of_rows.evaluate({x.data(), &y, &z}, count, workspace, levels.data());
    signs_of(levels, out.first(count));
    out = out.subspan(count);
    first.x += 2 * static_cast<std::int32_t>(count);
  }
}

void FormulaDomain::at(std::span<const Coord3> positions, std::span<Sign> out) const {
  const State& state = *state_;
  BatchFormula::Workspace workspace(state.of_points);
  Coordinates x, y, z, levels;
  for (std::size_t begin = 0; begin < out.size(); begin += batch_limit) {
    const std::size_t count = std::min(out.size() - begin, batch_limit);
    for (std::size_t i = 0; i < count; ++i) {
      const Point3 point = state.frame.world(positions[begin + i]);
      x[i] = point[0];
      y[i] = point[1];
      z[i] = point[2];
    }
    state.of_points.evaluate({x.data(), y.data(), z.data()}, count, workspace, levels.data());
    signs_of(levels, out.subspan(begin, count));
  }
}

/// The axes are the world's and rounding is monotone: the corners of the box
/// bound the coordinates of all its points as computed.
Extent FormulaDomain::extent(const LatticeBox& box) const {
  const State::CutFormula& formula = state_->formula;
  const Point3 low = state_->frame.world(steps * box.low);
  const Point3 high = state_->frame.world(steps * box.high);
  std::array<Range, 3> sides;
  for (std::size_t a = 0; a < 3; ++a) sides[a] = {low[a], high[a], false};
  const std::vector<Range> found = ranges(formula.tape, formula.level, sides);
  if (found[formula.beyond].low > 0) return Extent::outside;
  const Range& level = found[formula.level];
  if (level.may_be_nan) return Extent::mixed;
  if (level.low > 0) return Extent::outside;
  return level.high < 0 ? Extent::inside : Extent::mixed;
}

Solid formula_solid(const std::string& formula, const Bounds& bounds) {
  Tape unused;
  parse(formula, unused);  // refuses what it cannot read now, not when there is a lattice
  return {bounds, [formula, bounds](const PlacedLattice& around) {
            return std::make_shared<FormulaDomain>(formula, bounds, around);
          }};
}

}  // namespace certet
