#pragma once
/// \file
/// Where surfaces of triangles are no manifold, are open, or end.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/context.hpp"
#include "certet/pieces.hpp"
#include "certet/survey.hpp"

namespace certet::core {

/// The points of a face, as `BoundaryFace` has them.
using FacePoints = std::array<std::uint64_t, 3>;

/// Looks around all vertices of a closed surface.  \throws Error `cancelled`.
SurfaceFaults find_surface_faults(std::span<const BoundaryFace> surface,
                                  std::span<const Point3> points, Context& context);

/// What there is to be said of the surface of a region, or of an interface.
struct SheetFaults {
  std::uint64_t open_edges = 0;    ///< not run through as often forwards as backwards
  std::uint64_t border_edges = 0;  ///< in an odd number of triangles
  std::uint64_t loose_edges = 0;   ///< of those, where fewer than three regions meet, the outside
                                   ///< being one
  std::uint64_t overfull_edges = 0;  ///< in more than two triangles
  std::uint64_t odd_vertices = 0;  ///< around which the triangles are no closed fan nor, of an
                                   ///< interface, an open one

  SheetFaults& operator+=(const SheetFaults& other);
};

struct AllSheetFaults {
  SurfaceFaults outer;
  std::vector<SheetFaults> regions;     ///< as the survey has them
  std::vector<SheetFaults> interfaces;  ///< as the survey has them
};

/// The same of all surfaces of a mesh at once.  `misoriented` are the faces of interfaces, sorted,
/// that the greater label sees the same way round as the lesser.  The result does not depend on
/// the number of threads.  \throws Error `cancelled`.
AllSheetFaults find_sheet_faults(const Survey& survey, std::span<const FacePoints> misoriented,
                                 std::span<const Point3> points, Context& context);

}  // namespace certet::core
