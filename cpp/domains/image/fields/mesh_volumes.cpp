#include "mesh_volumes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "certet/quality.hpp"
#include "certet/stuffing.hpp"
#include "engine/parallel.hpp"
#include "fields/for_each_tile.hpp"
#include "mesh/quality/extremes.hpp"

namespace certet::fields {
namespace {

/// Less than 2^60, as `VolumesFit` of the certificate has it.
std::int64_t six_volume(const Coord3& p, const Coord3& q, const Coord3& r, const Coord3& s) {
  const auto edge = [&p](const Coord3& to) {
    return std::array<std::int64_t, 3>{to.x - p.x, to.y - p.y, to.z - p.z};
  };
  const auto u = edge(q), v = edge(r), w = edge(s);
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
         u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/// Layer by layer.
WideSum six_volume_of(const Stuffing& stuffing, Material material, Context& context) {
  WideSum sum;
  std::vector<Coord3> points;
  std::vector<Tet<std::uint64_t>> tets;
  std::vector<Material> materials;
  for (std::int32_t k = 0; k < stuffing.layers(); ++k) {
    const std::int32_t end = std::min(k + 2, stuffing.layers());
    const std::uint64_t first = stuffing.first_point(k);
    points.resize(stuffing.first_point(end) - first);
    tets.resize(stuffing.first_tet(k + 1) - stuffing.first_tet(k));
    materials.assign(tets.size(), 1);  // all that a solid of one material has
    stuffing.emit_points(k, end, points, context);
    stuffing.emit_tets(k, k + 1, std::span(tets), context);
    if (stuffing.has_interfaces()) stuffing.emit_materials(k, k + 1, materials, context);
    for (std::size_t t = 0; t < tets.size(); ++t)
      if (materials[t] == material)
        sum += six_volume(points[tets[t][0] - first], points[tets[t][1] - first],
                          points[tets[t][2] - first], points[tets[t][3] - first]);
  }
  return sum;
}

}  // namespace

std::vector<double> mesh_volumes(const Domain& domain, const std::vector<RegionPart>& parts,
                                 const Context& context) {
  std::vector<double> volumes(parts.size());
  for_each_tile(context, parts.size(), [&](std::size_t p) {
    core::OneThread alone;
    const Stuffing stuffing(domain, parts[p].lattice, Method::embedded, alone);
    volumes[p] = core::long_edges_cubed(six_volume_of(stuffing, parts[p].material, alone));
  });
  return volumes;
}

}  // namespace certet::fields
