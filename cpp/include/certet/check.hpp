#pragma once
/// \file
/// Verifying a finished mesh anew, from its points and tetrahedra alone.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "certet/context.hpp"
#include "certet/quality.hpp"

namespace certet {

/// What `check` found.
struct CheckReport {
  Quality quality;                       ///< in the coordinates given, of the tetrahedra
                                         ///< with good indices
  std::uint64_t points = 0;
  std::uint64_t unused_points = 0;
  std::uint64_t nonfinite_points = 0;
  std::uint64_t duplicate_points = 0;    ///< points at the very place of an earlier one
  std::uint64_t bad_indices = 0;         ///< tetrahedra naming a point that is not there, or one twice
  std::uint64_t overfull_faces = 0;      ///< faces in three or more tetrahedra
  std::uint64_t misoriented_faces = 0;   ///< inner faces that both sides see the same way round
  std::uint64_t boundary_faces = 0;
  std::uint64_t open_edges = 0;          ///< boundary edges where the surface is not closed or not oriented
  std::vector<std::string> failures;     ///< one sentence for each broken property; empty: all is well
};

/// Verifies: there is a mesh, indices valid, every face in at most two
/// tetrahedra, boundary closed and oriented, all volumes positive, every point
/// used, finite and by itself.  Tetrahedra with bad indices are left out of all
/// that follows.  Sentences name the first offender, counted from 0.
///
/// Takes 32 bytes for each tetrahedron (64 from 2^31 points on) and some 20 for
/// each point, beside the mesh.
///
/// Works with the threads of the context; the report does not depend on them.
/// \throws Error `cancelled`.
CheckReport check(std::span<const Point3> points, std::span<const Tet<std::uint32_t>> tets,
                  Context& context);
CheckReport check(std::span<const Point3> points, std::span<const Tet<std::uint64_t>> tets,
                  Context& context);

inline CheckReport check(std::span<const Point3> points,
                         std::span<const Tet<std::uint32_t>> tets) {
  Context context;
  return check(points, tets, context);
}
inline CheckReport check(std::span<const Point3> points,
                         std::span<const Tet<std::uint64_t>> tets) {
  Context context;
  return check(points, tets, context);
}

/// Verifies a mesh in memory, in world coordinates.
CheckReport check(const Mesh& mesh, Context& context);
inline CheckReport check(const Mesh& mesh) {
  Context context;
  return check(mesh, context);
}

}  // namespace certet
