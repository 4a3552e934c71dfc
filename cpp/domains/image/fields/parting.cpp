#include "parting.hpp"

#include "certet/lattice/coord3.hpp"
#include "fields/field_cell.hpp"
#include "fields/labelling.hpp"

namespace certet::fields {
namespace {

/// On which side points of an edge are.  The cell of the last point is kept.
class Sides {
 public:
  Sides(const NodeFields& fields, const FieldEdge& edge) : fields_(fields), edge_(edge) {}

  bool is_first(const FieldPoint& point) {
    if (point.cell() != at_) enter(point.cell());
    const auto within = point.within();
    if (some_forced_) {
      const Material forced = forced_[Labelling::nearest_corner(within)];
      if (forced != not_forced) return forced != edge_.of_last;
    }
    return trilinear(difference_, within) > 0;
  }

 private:
  static constexpr Material not_forced = -1;

  void enter(const std::array<std::int64_t, 3>& cell) {
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
    for (std::size_t c = 0; c < 8; ++c) {
      difference_[c] -= others[c];
      const Node& node = corners.node(c);
      forced_[c] = node.forced() ? corners.material(node.own()) : not_forced;
      some_forced_ = some_forced_ || node.forced();
    }
  }

  const NodeFields& fields_;
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

}  // namespace

std::uint16_t part(const NodeFields& fields, const FieldExtent& extent, const FieldEdge& edge) {
  Sides sides(fields, edge);
  const bool leaves = !extent.contains(edge.last);
  std::int32_t low = 0;
  for (std::int32_t half = steps / 2; half != 0; half /= 2) {
    const FieldPoint middle = point_of(edge, low + half);
    if ((!leaves || extent.contains(middle)) && sides.is_first(middle)) low += half;
  }
  return static_cast<std::uint16_t>(low);
}

}  // namespace certet::fields
