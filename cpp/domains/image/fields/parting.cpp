#include "parting.hpp"

#include <algorithm>
#include <bit>
#include <optional>

#include "certet/lattice/coord3.hpp"
#include "fields/edge_in_cell.hpp"

namespace certet::fields {
namespace {

FieldPoint point_of(const FieldEdge& edge, std::int32_t step) {
  FieldPoint point;
  for (std::size_t a = 0; a < 3; ++a)
    point.at[a] = edge.first.at[a] +
                  (((edge.last.at[a] - edge.first.at[a]) * step) >> step_bits);
  return point;
}

/// Whether all that lies between two points lies in a cell, its faces included.
bool holds(const Cell& cell, const FieldPoint& one, const FieldPoint& other) {
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
std::int32_t root_in(const FieldEdge& edge, const Cell& cell, const Corners& difference) {
  const std::size_t first = corner_at(cell, edge.first), last = corner_at(cell, edge.last);
  if (first < 8 && last < 8 && std::has_single_bit(first ^ last))
    return root_between(difference[first], difference[last]);
  return EdgeInCell(edge.first, edge.last, cell, difference).root(0, steps);
}

/// Of an edge in two cells, as between the centres of two: of which it crosses the common face
/// in its middle.
std::optional<std::int32_t> root_in_halves(EdgeSides& sides, const FieldEdge& edge) {
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

/// The last step of the first side between two whose points lie in one cell, and on one side
/// of its middle along each axis if labels are forced in it; none where it is not certain.
std::optional<std::int32_t> within_cell(EdgeSides& sides, const FieldEdge& edge,
                                        const FieldPoint& low_point, std::int32_t low,
                                        std::int32_t high) {
  if (const auto forced = sides.forced_at(low_point)) return *forced ? high - 1 : low;
  return EdgeInCell(edge.first, edge.last, low_point.cell(), sides.difference_at(low_point))
      .only_root(low, high);
}

/// By halves, until what is left lies in one cell.
std::uint16_t bisected(EdgeSides& sides, const FieldExtent& extent, bool leaves,
                       const FieldEdge& edge) {
  std::int32_t low = 0;
  FieldPoint low_point = edge.first, high_point = edge.last;
  bool tries = !leaves;
  for (std::int32_t half = steps / 2; half != 0; half /= 2) {
    if (tries && sides.are_together(low_point, high_point)) {
      tries = false;
      if (const auto root = within_cell(sides, edge, low_point, low, low + 2 * half))
        return static_cast<std::uint16_t>(*root);
    }
    const FieldPoint middle = point_of(edge, low + half);
    const bool is_first = (!leaves || extent.contains(middle)) && sides.is_first(middle);
    if (is_first) low += half;
    (is_first ? low_point : high_point) = middle;
  }
  return static_cast<std::uint16_t>(low);
}

}  // namespace

std::uint16_t Parting::operator()(const FieldEdge& edge) {
  sides_.start(edge);
  const bool leaves = !extent_.contains(edge.last);
  if (!leaves) {
    const Cell cell = point_of(edge, steps / 2).cell();
    if (holds(cell, edge.first, edge.last)) {
      if (const Corners* difference = sides_.difference_in(cell); difference != nullptr)
        return static_cast<std::uint16_t>(root_in(edge, cell, *difference));
    } else if (const auto root = root_in_halves(sides_, edge)) {
      return static_cast<std::uint16_t>(*root);
    }
  }
  return bisected(sides_, extent_, leaves, edge);
}

}  // namespace certet::fields
