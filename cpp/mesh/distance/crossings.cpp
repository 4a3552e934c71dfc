#include <algorithm>
#include <array>
#include <iterator>

#include "engine/parallel.hpp"
#include "shape_points.hpp"

namespace certet::distance {
namespace {

/// The lattice is looked at in bricks of so many units along each axis.
constexpr std::int32_t brick = 8;

Point3 place(Coord3 point) { return {double(point.x), double(point.y), double(point.z)}; }

/// From a lattice point on along an axis the material changes.
struct Crossed {
  Coord3 first;
  int axis;
  Material of_first;
  double low = 0, high = 1;

  [[nodiscard]] Point3 at(double share) const {
    Point3 point = place(first);
    point[static_cast<std::size_t>(axis)] += share;
    return point;
  }
};

/// The bricks of one row along x.
class Row {
 public:
  Row(const Sides& sides, Coord3 low, Coord3 high) : sides_(sides), question_(sides) {
    for (Coord3 at = low; at.x < high.x; at.x += brick)
      look_at({at, {std::min(at.x + brick, high.x), std::min(at.y + brick, high.y),
                    std::min(at.z + brick, high.z)}});
    bisect();
  }

  [[nodiscard]] std::vector<ShapePoint> points() const {
    std::vector<ShapePoint> points;
    for (const Crossed& one : crossed_)
      points.push_back({one.at((one.low + one.high) / 2), 1, one.axis});
    return points;
  }

 private:
  void look_at(const LatticeBox& box) {
    if (sides_.of(box)) return;
    const auto& [low, high] = box;
    question_.clear();
    for (std::int32_t z = low.z; z <= high.z; ++z)
      for (std::int32_t y = low.y; y <= high.y; ++y)
        for (std::int32_t x = low.x; x <= high.x; ++x) question_.add(place({x, y, z}));
    question_.ask();
    const std::size_t row = static_cast<std::size_t>(high.x - low.x) + 1;
    const std::size_t layer = row * (static_cast<std::size_t>(high.y - low.y) + 1);
    const std::array<std::size_t, 3> strides{1, row, layer};
    std::size_t at = 0;
    for (std::int32_t z = low.z; z <= high.z; ++z)
      for (std::int32_t y = low.y; y <= high.y; ++y)
        for (std::int32_t x = low.x; x <= high.x; ++x, ++at) {
          // Those of the far faces belong to the next brick.
          if (x == high.x || y == high.y || z == high.z) continue;
          for (std::size_t a = 0; a < 3; ++a)
            if (question_[at] != question_[at + strides[a]])
              crossed_.push_back({{x, y, z}, static_cast<int>(a), question_[at]});
        }
  }

  void bisect() {
    for (int bit = 0; bit < step_bits && !crossed_.empty(); ++bit) {
      question_.clear();
      for (const Crossed& one : crossed_) question_.add(one.at((one.low + one.high) / 2));
      question_.ask();
      for (std::size_t i = 0; i < crossed_.size(); ++i) {
        Crossed& one = crossed_[i];
        (question_[i] == one.of_first ? one.low : one.high) = (one.low + one.high) / 2;
      }
    }
  }

  const Sides& sides_;
  Question question_;
  std::vector<Crossed> crossed_;
};

}  // namespace

std::vector<ShapePoint> crossings(const Sides& sides, Context& context) {
  const Coord3 low = sides.domain.lattice().origin;
  const auto& cells = sides.domain.lattice().cells;
  const Coord3 high = low + Coord3{2 * cells[0], 2 * cells[1], 2 * cells[2]};
  const auto bricks = [](std::int32_t cells) { return (2 * std::int64_t{cells} + brick - 1) / brick; };
  const std::int64_t across = bricks(cells[1]);
  std::vector<std::vector<ShapePoint>> rows(static_cast<std::size_t>(across * bricks(cells[2])));
  core::parallel_for(context, Stage::emit, std::ssize(rows), [&](std::int64_t task) {
    const Coord3 at{low.x, low.y + brick * static_cast<std::int32_t>(task % across),
                    low.z + brick * static_cast<std::int32_t>(task / across)};
    rows[static_cast<std::size_t>(task)] = Row(sides, at, high).points();
  });
  std::vector<ShapePoint> all;
  for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
  return all;
}

}  // namespace certet::distance
