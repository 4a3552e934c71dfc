#include <algorithm>
#include <cmath>

#include "certet/quality.hpp"
#include "measurement.hpp"

namespace certet {
namespace {

using core::CarefulTet;
using core::Copies;
using core::lanes;
using core::Measurement;
using core::TetBlock;

/// Copies of lanes that stand for one tetrahedron each.
constexpr Copies one_each = [] {
  Copies copies{};
  copies.fill(1);
  return copies;
}();

/// The sum of the lanes that are finite.
double sum(core::Lanes values) {
  for (double& value : values) value = std::isfinite(value) ? value : 0;
  return core::folded(values, [](double a, double b) { return a + b; });
}

template <class Index>
Quality world(std::span<const Point3> points, std::uint64_t first_point,
              std::span<const Tet<Index>> tets, Histogram histogram) {
  Measurement measurement(histogram);
  TetBlock block;
  double six_volumes = 0;
  const auto point = [&](Index index) -> const Point3& { return points[index - first_point]; };
  const auto positive = [&block](std::size_t i) {
    return block.in_range(i) ? block.six_volume[i] > 0 : CarefulTet(block.get(i)).positive();
  };
  for (std::size_t begin = 0; begin < tets.size(); begin += lanes) {
    const std::size_t count = std::min(lanes, tets.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      const Tet<Index>& tet = tets[begin + i];
      const Point3& p = point(tet[0]);
      const Point3& q = point(tet[1]);
      const Point3& r = point(tet[2]);
      const Point3& s = point(tet[3]);
      block.set(i, {{q[0] - p[0], q[1] - p[1], q[2] - p[2]},
                    {r[0] - p[0], r[1] - p[1], r[2] - p[2]},
                    {s[0] - p[0], s[1] - p[1], s[2] - p[2]}});
    }
    block.repeat_first(count);
    block.compute();
    measurement.add(block, count, one_each, positive);
    for (std::size_t i = count; i < lanes; ++i) block.six_volume[i] = 0;
    six_volumes += sum(block.six_volume);
  }
  Quality quality = measurement.result();
  quality.volume = six_volumes / 6;
  return quality;
}

}  // namespace

Quality measure_world(std::span<const Point3> points, std::uint64_t first_point,
                      std::span<const Tet<std::uint32_t>> tets, Histogram histogram) {
  return world(points, first_point, tets, histogram);
}

Quality measure_world(std::span<const Point3> points, std::uint64_t first_point,
                      std::span<const Tet<std::uint64_t>> tets, Histogram histogram) {
  return world(points, first_point, tets, histogram);
}

}  // namespace certet
