#include "piece_count.hpp"

#include <algorithm>
#include <vector>

#include "joined_parts.hpp"
#include "piece_tets.hpp"
#include "places.hpp"

namespace certet::core {
namespace {

Point3 middle(const Point3& a, const Point3& b) {
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])};
}

/// How many there are, and the places of the first few.
SurfaceFaults place_faults(const FaultPoints& faults, const WarpedLattice& warped,
                           const Lattice& lattice, const Frame& frame) {
  const auto place = [&](const PointIndex& point) {
    return frame.world(place_of(warped, lattice, point));
  };
  SurfaceFaults placed{faults.edges.size(), faults.vertices.size(), {}, {}};
  for (std::size_t n = 0; n < std::min(most_places, faults.edges.size()); ++n)
    placed.edge_places.push_back(middle(place(faults.edges[n][0]), place(faults.edges[n][1])));
  for (std::size_t n = 0; n < std::min(most_places, faults.vertices.size()); ++n)
    placed.vertex_places.push_back(place(faults.vertices[n]));
  return placed;
}

/// Of each material.
std::vector<RegionPieces> count_regions(MeshParts& parts, std::span<const std::int32_t> labels) {
  std::vector<PieceCount> counts(labels.size());
  auto& [by_faces, by_vertices] = parts.regions;
  for (std::uint32_t n = 0; n < by_faces.size(); ++n) {
    if (by_faces.find(n) != n) continue;
    PieceCount& count = counts[static_cast<std::size_t>(parts.material(n)) - 1];
    ++count.by_faces;
    count.by_vertices += by_vertices.find(n) == n ? 1 : 0;
  }
  std::vector<RegionPieces> regions;
  for (std::size_t m = 0; m < labels.size(); ++m)
    if (counts[m].by_faces != 0) regions.push_back({labels[m], counts[m]});
  std::ranges::sort(regions, {}, &RegionPieces::label);
  return regions;
}

}  // namespace

Pieces count_pieces(const WarpedLattice& warped, const Lattice& lattice,
                    std::span<const std::int32_t> labels, std::uint64_t tets, const Frame& frame,
                    Context& context) {
  MeshParts parts = join_parts(warped.planes, context);
  Pieces pieces;
  const NumberedSets by_faces = number_sets(parts.whole.by_faces);
  pieces.whole = {by_faces.count, number_sets(parts.whole.by_vertices).count};
  pieces.largest = tets;
  if (by_faces.count > 1)
    pieces.largest = std::ranges::max(count_tets_of_pieces(parts, by_faces, context));
  pieces.regions = count_regions(parts, labels);
  pieces.surface = place_faults(parts.faults, warped, lattice, frame);
  return pieces;
}

}  // namespace certet::core
