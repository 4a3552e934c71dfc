#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <vector>

#include "certet/error.hpp"
#include "certet/kept.hpp"
#include "certet/lattice/orientation.hpp"
#include "certet/quality.hpp"
#include "certet/volume_estimate.hpp"
#include "engine/parallel.hpp"

namespace certet {
namespace {

/// What is lost or gained beyond this share of the volume is told.
constexpr double told_share = 0.02;

/// Of the tetrahedra of a layer, in steps cubed.
template <class Index>
WideSum six_volumes(const Stuffing& stuffing, std::int32_t layer) {
  Context alone;
  alone.threads = 1;
  const std::int32_t behind = stuffing.points_end(layer + 1);
  const std::uint64_t first = stuffing.first_point(layer);
  std::vector<Coord3> points(stuffing.first_point(behind) - first);
  std::vector<Tet<Index>> tets(stuffing.first_tet(layer + 1) - stuffing.first_tet(layer));
  stuffing.emit_points(layer, behind, points, alone);
  stuffing.emit_tets(layer, layer + 1, std::span<Tet<Index>>(tets), alone);
  WideSum sum;
  for (const Tet<Index>& t : tets)
    sum += six_volume(points[t[0] - first], points[t[1] - first], points[t[2] - first],
                      points[t[3] - first]);
  return sum;
}

}  // namespace

bool ShapeVolume::may_be(double mesh_volume) const {
  return std::fabs(mesh_volume - volume) <= told_share * volume + doubt;
}

bool ShapeVolume::surely_is(double mesh_volume) const {
  return may_be(mesh_volume) && doubt <= told_share * volume;
}

ShapeVolume volume_of(const SizedShape& shape, const PlacedDomain& domain,
                      const Context& context) {
  if (shape.volume) return {*shape.volume, 0, true};
  // As many points as a quarter of the lattice's.
  const auto& cells = domain.lattice().cells;
  const double points = 0.5 * cells[0] * cells[1] * cells[2];
  const auto samples = static_cast<std::uint64_t>(std::clamp(points, 2e5, 2e6));
  const VolumeEstimate found =
      estimate_volume(domain, domain.lattice(), domain.frame(), samples, context);
  return {found.volume, 3 * found.deviation, false};
}

double volume_of(const Stuffing& stuffing, const Frame& frame, Context& context) {
  const bool few = stuffing.point_count() <= std::numeric_limits<std::uint32_t>::max();
  std::vector<WideSum> layers(static_cast<std::size_t>(stuffing.layers()));
  try {
    core::parallel_for(context, Stage::emit, stuffing.layers(), [&](std::int64_t task) {
      const auto layer = static_cast<std::int32_t>(task);
      if (stuffing.first_tet(layer + 1) == stuffing.first_tet(layer)) return;
      layers[static_cast<std::size_t>(layer)] = few ? six_volumes<std::uint32_t>(stuffing, layer)
                                                    : six_volumes<std::uint64_t>(stuffing, layer);
    });
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "out of memory while measuring the mesh");
  }
  WideSum sum;
  for (const WideSum& layer : layers) sum += layer;
  return sum.value() / 6 * std::pow(frame.size / (2.0 * steps), 3);
}

}  // namespace certet
