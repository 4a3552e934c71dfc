#pragma once
/// \file
/// The edges of a mesh's surfaces, and the elements around them.

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "certet/domain.hpp"
#include "certet/middle_nodes.hpp"
#include "certet/survey.hpp"

namespace certet::quadratic {

/// An element that has an edge on a surface.
struct SurfaceElement {
  std::array<std::uint64_t, 6> nodes;  ///< its middle nodes, in the order of `tet_edges`
  TetCorners corners;
};

/// A triangle of a surface.
struct SurfaceTriangle {
  std::array<std::uint64_t, 3> points;
  std::array<std::int32_t, 2> labels;  ///< within and beyond; the latter counts where there is one
  bool border;                         ///< lies where the shape is cut off
  bool outer;                          ///< has no other region beyond it
};

/// An edge of which the middle node is to be put on the surface.
struct SurfaceEdge {
  std::uint64_t node;
  std::array<std::int64_t, 3> middle2;  ///< twice its middle, in steps
  std::array<std::int64_t, 3> normal;   ///< outward; of any length, 0: none
  Coord3 inward;                        ///< from a face that cuts the shape off, a few steps
  std::int32_t length;                  ///< the greatest of its three extents, in steps
  std::int32_t label;                   ///< within
  bool outer;                           ///< of the boundary
  bool seam;                            ///< of surfaces of several pairs of regions
};

/// The points of a surface, by growing numbers.
class SurfacePoints {
 public:
  using Point = std::pair<std::uint64_t, Coord3>;
  explicit SurfacePoints(std::vector<Point> points) : points_(std::move(points)) {}
  [[nodiscard]] Coord3 at(std::uint64_t point) const;

 private:
  std::vector<Point> points_;
};

/// All triangles of the boundary and of the interfaces.
std::vector<SurfaceTriangle> surface_triangles(const Survey& survey);

/// Their edges, by growing numbers of middle nodes, but for those within a border.
std::vector<SurfaceEdge> surface_edges(const std::vector<SurfaceTriangle>& triangles,
                                       const MiddleNodes& middles, const SurfacePoints& points);

}  // namespace certet::quadratic
