#include "parting.hpp"

#include <algorithm>
#include <bit>
#include <optional>

#include "certet/lattice/coord3.hpp"
#include "fields/edge_in_cell.hpp"
#include "fields/field_cell.hpp"
#include "fields/labelling.hpp"

namespace certet::fields {
namespace {

/// On which side points of an edge are.  The cell of the last point is kept.
class Sides {
 public:
  Sides(const NodeFields& fields, bool force, const FieldEdge& edge)
      : fields_(fields), force_(force), edge_(edge) {}

  bool is_first(const FieldPoint& point) {
    if (point.cell() != at_) enter(point.cell());
    const auto within = point.within();
    if (some_forced_) {
      const Material forced = forced_[Labelling::nearest_corner(within)];
      if (forced != not_forced) return forced != edge_.of_last;
    }
    return trilinear(difference_, within) > 0;
  }

  /// Of the two fields, at the corners of a cell; nullptr where one of these is forced.
  const Corners* difference_in(const Cell& cell) {
    enter(cell);
    return some_forced_ ? nullptr : &difference_;
  }

 private:
  static constexpr Material not_forced = -1;

  void enter(const Cell& cell) {
    at_ = cell;
    some_forced_ = false;
    const BlockView block = fields_.block(cell);
    if (block.labels == 0) {
      difference_.fill(block.only == edge_.of_last ? -1 : 1);
      return;
    }
    const FieldCell corners(block, cell);
    difference_ = corners.values_of(edge_.of_first);
    const Corners others = corners.values_of(edge_.of_last);
    for (std::size_t c = 0; c < 8; ++c) difference_[c] -= others[c];
    if (!force_) return;
    for (std::size_t c = 0; c < 8; ++c) {
      const Node& node = corners.node(c);
      const bool forced = node.at_risk();
      forced_[c] = forced ? corners.material(node.own()) : not_forced;
      some_forced_ = some_forced_ || forced;
    }
  }

  const NodeFields& fields_;
  bool force_;
  const FieldEdge& edge_;
  std::array<std::int64_t, 3> at_{-1, -1, -1};
  Corners difference_{};  ///< of the first material's field and the last one's
  std::array<Material, 8> forced_{};
  bool some_forced_ = false;
};

FieldPoint point_of(const FieldEdge& edge, std::int32_t step) {
  FieldPoint point;
  for (std::size_t a = 0; a < 3; ++a)
    point.at[a] = edge.first.at[a] +
                  (((edge.last.at[a] - edge.first.at[a]) * step) >> step_bits);
  return point;
}

/// Whether all that lies between two points lies in a cell, its faces included.
bool holds(const Cell& cell, const FieldPoint& one,
           const FieldPoint& other) {
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t low = cell[a] * point_one, high = low + point_one;
    if (std::min(one.at[a], other.at[a]) < low || std::max(one.at[a], other.at[a]) > high)
      return false;
  }
  return true;
}

/// The corner of a cell at which a point is, or 8.
std::size_t corner_at(const Cell& cell, const FieldPoint& point) {
  std::size_t corner = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t within = point.at[a] - cell[a] * point_one;
    if (within != 0 && within != point_one) return 8;
    corner |= static_cast<std::size_t>(within != 0) << a;
  }
  return corner;
}

/// As `EdgeInCell::root`, where the difference is a straight line between two whole numbers:
/// the last step at which it is above 0.
std::int32_t root_between(std::int64_t at_first, std::int64_t at_last) {
  if (at_first <= 0) return 0;
  if (at_last > 0) return steps - 1;
  return static_cast<std::int32_t>((at_first * steps - 1) / (at_first - at_last));
}

/// Of an edge in one cell where nothing is forced.
std::int32_t root_in(const FieldEdge& edge, const Cell& cell,
                     const Corners& difference) {
  const std::size_t first = corner_at(cell, edge.first), last = corner_at(cell, edge.last);
  if (first < 8 && last < 8 && std::has_single_bit(first ^ last))
    return root_between(difference[first], difference[last]);
  return EdgeInCell(edge.first, edge.last, cell, difference).root(0, steps);
}

/// Of an edge in two cells, as between the centres of two: of which it crosses the common face
/// in its middle.
std::optional<std::int32_t> root_in_halves(Sides& sides, const FieldEdge& edge) {
  constexpr std::int32_t half = steps / 2;
  const FieldPoint middle = point_of(edge, half);
  const auto near_first = point_of(edge, half / 2).cell();
  const auto near_last = point_of(edge, half + half / 2).cell();
  if (!holds(near_first, edge.first, middle) || !holds(near_last, middle, edge.last))
    return std::nullopt;
  const Corners* difference = sides.difference_in(near_first);
  if (difference == nullptr) return std::nullopt;
  const EdgeInCell before(edge.first, edge.last, near_first, *difference);
  if (before.at(half) <= 0) return before.root(0, half);
  difference = sides.difference_in(near_last);
  if (difference == nullptr) return std::nullopt;
  return EdgeInCell(edge.first, edge.last, near_last, *difference).root(half, steps);
}

/// Between two steps whose points lie in one cell the one root that there mostly is is found at
/// once.
std::uint16_t bisected(Sides& sides, const FieldExtent& extent, bool leaves,
                       const FieldEdge& edge) {
  std::int32_t low = 0;
  Cell of_low = edge.first.cell(), of_high = edge.last.cell();
  bool tries = !leaves;
  for (std::int32_t half = steps / 2; half != 0; half /= 2) {
    if (tries && of_low == of_high) {
      tries = false;
      if (const Corners* difference = sides.difference_in(of_low); difference != nullptr)
        if (const auto root = EdgeInCell(edge.first, edge.last, of_low, *difference)
                                  .only_root(low, low + 2 * half))
          return static_cast<std::uint16_t>(*root);
    }
    const FieldPoint middle = point_of(edge, low + half);
    const bool is_first = (!leaves || extent.contains(middle)) && sides.is_first(middle);
    if (is_first) low += half;
    (is_first ? of_low : of_high) = middle.cell();
  }
  return static_cast<std::uint16_t>(low);
}

}  // namespace

std::uint16_t part(const NodeFields& fields, const FieldExtent& extent, bool force,
                   const FieldEdge& edge) {
  Sides sides(fields, force, edge);
  const bool leaves = !extent.contains(edge.last);
  if (!leaves) {
    const auto cell = point_of(edge, steps / 2).cell();
    if (holds(cell, edge.first, edge.last)) {
      if (const Corners* difference = sides.difference_in(cell); difference != nullptr)
        return static_cast<std::uint16_t>(root_in(edge, cell, *difference));
    } else if (const auto root = root_in_halves(sides, edge)) {
      return static_cast<std::uint16_t>(*root);
    }
  }
  return bisected(sides, extent, leaves, edge);
}

}  // namespace certet::fields
