#include "worst_angles.hpp"

#include <algorithm>

#include "mesh/quality/tet_block.hpp"
#include "mesh/ranges.hpp"
#include "vector.hpp"

namespace certet::optimising {
namespace {

struct Extremes {
  double greatest = -1, least = 1;  ///< cos |cos|
};

template <class Index>
Extremes measure(std::span<const Coord3> points, std::span<const Tet<Index>> tets,
                 std::span<float> worst) {
  Extremes all;
  core::TetBlock block;
  for (std::size_t begin = 0; begin < tets.size(); begin += core::lanes) {
    const std::size_t count = std::min(core::lanes, tets.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      const Tet<Index>& tet = tets[begin + i];
      const Coord3 p = points[tet[0]];
      block.set(i, {between(p, points[tet[1]]), between(p, points[tet[2]]),
                    between(p, points[tet[3]])});
    }
    block.repeat_first(count);
    block.compute();
    for (std::size_t i = 0; i < count; ++i) {
      all.greatest = std::max(all.greatest, block.greatest[i]);
      all.least = std::min(all.least, block.least[i]);
      worst[begin + i] = static_cast<float>(std::max(block.greatest[i], -block.least[i]));
    }
  }
  return all;
}

template <class Index>
WorstAngles worst_of(std::span<const Coord3> points, std::span<const Tet<Index>> tets,
                     Context& context) {
  WorstAngles found{std::vector<float>(tets.size())};
  const auto parts = core::in_ranges(
      tets.size(), core::tets_per_task, Stage::emit, context,
      [&](std::size_t begin, std::size_t end) {
        return measure(points, tets.subspan(begin, end - begin),
                       std::span(found.of_tets).subspan(begin, end - begin));
      });
  Extremes all;
  for (const Extremes& part : parts) {
    all.greatest = std::max(all.greatest, part.greatest);
    all.least = std::min(all.least, part.least);
  }
  found.acute = std::max(all.greatest, 0.0);
  found.obtuse = std::max(-all.least, 0.0);
  return found;
}

}  // namespace

WorstAngles worst_angles(std::span<const Coord3> points,
                         std::span<const Tet<std::uint32_t>> tets, Context& context) {
  return worst_of(points, tets, context);
}

WorstAngles worst_angles(std::span<const Coord3> points,
                         std::span<const Tet<std::uint64_t>> tets, Context& context) {
  return worst_of(points, tets, context);
}

}  // namespace certet::optimising
