#pragma once
/// \file
/// Verifying a finished mesh of several labels: as a whole, each region, and each interface.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/check.hpp"
#include "certet/context.hpp"
#include "certet/mesh.hpp"
#include "certet/pieces.hpp"
#include "certet/survey.hpp"

namespace certet {

/// Where a surface is no manifold.
struct ManifoldFaults {
  std::uint64_t edges = 0;     ///< in more than two of its triangles
  std::uint64_t vertices = 0;  ///< around which they are not one fan
  friend bool operator==(const ManifoldFaults&, const ManifoldFaults&) = default;
};

/// What `examine` found of the tetrahedra of one label.
struct RegionReport {
  std::int32_t label = 0;
  Quality quality;
  PieceCount pieces;
  std::uint64_t faces = 0;  ///< of its surface: those that one of its tetrahedra has alone
  double area = 0;          ///< of its surface
  std::uint64_t open_edges = 0;  ///< where its surface is not closed or not oriented
  ManifoldFaults nonmanifold;
};

/// What it found of where two regions touch.
struct InterfaceReport {
  std::array<std::int32_t, 2> labels{};  ///< the lesser first
  std::uint64_t triangles = 0;
  double area = 0;
  std::uint64_t border_edges = 0;  ///< where it ends
  std::uint64_t loose_edges = 0;   ///< of those, where neither a third region nor the outside is
  ManifoldFaults nonmanifold;      ///< its border taken for what it is
};

/// What `examine` found.
struct Examination {
  CheckReport report;  ///< with one sentence more for each region or interface that is broken
  Pieces pieces;       ///< as `count_pieces` counts them
  Survey survey;       ///< its regions (without volumes), boundary and interfaces
  std::vector<RegionReport> regions;       ///< by growing labels; none without labels
  std::vector<InterfaceReport> interfaces; ///< as `survey.interfaces`
};

/// Does all that `check`, `count_pieces` and `survey` do, in less time, for faces are brought
/// together once; and looks at each region and each interface.  The surface of a region must be
/// closed; an interface must end where a third region or the outside is and nowhere else.  A
/// surface that is no manifold is told of, and is no defect.
///
/// Takes some 40 bytes for each tetrahedron and each point, and 200 for each face on a surface
/// or an interface, beside the mesh.  The result does not depend on the number of threads.
/// \throws Error `cancelled`.
Examination examine(std::span<const Point3> points, std::span<const Tet<std::uint32_t>> tets,
                    std::span<const std::int32_t> labels, Context& context);
Examination examine(std::span<const Point3> points, std::span<const Tet<std::uint64_t>> tets,
                    std::span<const std::int32_t> labels, Context& context);

/// The area of a triangle, in the units of its points, squared.
double area_of(const Point3& a, const Point3& b, const Point3& c);

}  // namespace certet
