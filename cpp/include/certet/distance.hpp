#pragma once
/// \file
/// How far a mesh's surface is from its shape's, and back.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/context.hpp"
#include "certet/frame.hpp"
#include "certet/mesh.hpp"
#include "certet/placed_domain.hpp"
#include "certet/solid.hpp"
#include "certet/stuffing.hpp"
#include "certet/survey.hpp"

namespace certet {

/// The triangles of a mesh's boundary, and those of its interfaces where it has some.
struct MeshSurface {
  std::vector<Point3> points;  ///< world coordinates
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< numbers of points
  bool interfaces = false;  ///< whether the shape's surface is where any two materials meet, too
};

/// Of a mesh that is counted but not written, in memory for its surface alone.
/// \throws Error `cancelled`, `too_large` (out of memory, or 2^32 points); what the domain throws.
MeshSurface surface_of(const Stuffing& stuffing, const Frame& frame, Context& context);
/// Of a mesh in memory.  \throws Error `cancelled`, `too_large`.
MeshSurface surface_of(const Mesh& mesh, Context& context);
/// Of a surveyed mesh with these points; without its interfaces if they are not wanted.
/// \throws Error `too_large`.
MeshSurface surface_of(std::span<const Point3> points, const Survey& survey, bool interfaces);

/// How far points of one surface are from another.
struct Distance {
  double greatest = 0;       ///< world units
  double rms = 0;            ///< root mean square over the area, world units
  Point3 at{0, 0, 0};        ///< where it is the greatest: a point of the first surface, in the world
  std::uint64_t points = 0;  ///< at which it was measured
};

/// Both ways.
struct DistanceFigures {
  Distance to_shape;    ///< from the mesh's surface
  Distance to_mesh;     ///< from the shape's surface
  double edge = 0;      ///< the long edge of the shape's lattice, in world units
  bool exact = false;   ///< the shape is known by its triangles, and not by its answers alone
};

/// Measures how far a mesh is from a shape, and the shape from the mesh.
///
/// The mesh is measured at the vertices of its surface, the middles of edges and the centroids of
/// triangles, which together integrate cubics over each triangle.  Where the domain has
/// `triangles` that are all of its surface, the nearest of them is found, and they are measured
/// themselves, cut into parts with sides of half a long edge at most: at their corners and
/// centroids.
///
/// Of any other domain the surface is where its answers change (from one material to another
/// where `mesh.interfaces`, else from inside to outside; also where the shape is cut off).  Around
/// a point a ball grows until one of fourteen probes on it is in another material; then it shrinks
/// and the probes turn as long as one still is, to a hundredth of its radius and last to a step
/// of the lattice.  So no distance is less than the true one by more than two steps, and, of what is
/// within a long edge, where the surface is smooth none is more by a hundredth, and at its corners
/// by a few.  The shape is measured where lines along the axes of the lattice, half a long edge
/// apart, pass through its surface: to a step, by bisection.  Each counts for the area that it
/// stands for, by the normal of the nearest triangle.
///
/// The figures do not depend on the number of threads.
/// \throws Error `empty_domain` where one of the surfaces has no points, `cancelled`,
/// `too_large` (out of memory); what the domain throws.
DistanceFigures measure_distance(const MeshSurface& mesh, const PlacedDomain& shape,
                                 Context& context);

/// The same of any solid, and a mesh with these points: as on a lattice with this long edge, or
/// with the mean length of the edges of the mesh's surface where it is 0.  Interfaces are part of
/// the surfaces where both have some: the solid several materials, and the mesh too.
/// \throws Error as that, and `solid_domain`.
DistanceFigures measure_distance(std::span<const Point3> points, const Survey& survey,
                                 const Solid& shape, double edge, Context& context);

/// The mean length of the edges of a surface's triangles, in world units; 0 where it has none.
double mean_edge(const MeshSurface& surface);

/// Distances of points of the world from the surface of a shape, as `measure_distance` finds
/// them, in world units; `interfaces` as in `MeshSurface`.
/// \throws Error as that.
std::vector<double> distances_from(const PlacedDomain& shape, bool interfaces,
                                   std::span<const Point3> points, Context& context);

}  // namespace certet
