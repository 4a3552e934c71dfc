#pragma once
/// \file
/// A mesh of several labels, and the surfaces of its regions.

#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "property/exact.hpp"
#include "topology.hpp"

namespace labelled {

using certet::Coord3;
using Tet = std::array<std::uint32_t, 4>;
/// Counterclockwise as seen from outside, the lowest number first.
using Triangle = std::array<std::uint32_t, 3>;

struct LabelledMesh {
  std::vector<Coord3> points;  ///< in steps
  std::vector<Tet> tets;
  std::vector<std::int32_t> labels;

  [[nodiscard]] exact::Tet corners(const Tet& tet) const {
    return {points[tet[0]], points[tet[1]], points[tet[2]], points[tet[3]]};
  }
  [[nodiscard]] std::set<std::int32_t> label_set() const { return {labels.begin(), labels.end()}; }
};

/// The same triangle seen from the other side.
constexpr Triangle turned(const Triangle& t) { return {t[0], t[2], t[1]}; }

/// The tetrahedra of some labels.
settling::Tets region_of(const LabelledMesh& mesh, const std::set<std::int32_t>& labels);

/// Faces that only one of the tetrahedra has, in order.
std::vector<Triangle> surface_of(const std::vector<Tet>& tets);

/// What a surface is like.
struct SurfaceCounts {
  std::uint64_t open_edges = 0;       ///< not as often one way as the other
  std::uint64_t crowded_edges = 0;    ///< in more than two triangles
  std::set<std::uint32_t> pinched;    ///< points with several fans
};
SurfaceCounts counts_of(const std::vector<Triangle>& surface);

/// Six times the volume within, in steps cubed.
exact::Wide six_volume_within(const LabelledMesh& mesh, const std::vector<Triangle>& surface);

}  // namespace labelled
