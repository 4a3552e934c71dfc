#pragma once
/// \file
/// What the view of a page is made of.

#include <array>
#include <cstdint>
#include <string>

#include "certet/formats.hpp"
#include "regions.hpp"
#include "separating_faces.hpp"
#include "vector.hpp"

namespace certet::view {

/// How much a scene may hold.
struct SceneLimits {
  std::uint64_t surface_triangles = 240'000;  ///< interfaces among them
  std::uint64_t cut_triangles = 1'000'000;  ///< of all planes together; a wish: they are
                                          ///< estimated before they are found
  int planes = 40;                        ///< of an axis
};

/// A mesh packed for the view.  `data` is a Packing in base64:
///
///  - points: their number, then for each the three differences from the one
///    before, in units of box width / 65535 from the low corner;
///  - the surface: the number of triangles, for each its points (the first as a
///    difference from the first of the triangle before, the others from the first),
///    the difference of its region's place from that before, that of the region
///    behind it counted from 1 or 0 for none, its tetrahedron's worst angle in 255ths
///    of the best as one byte, and the sides of the tetrahedron; interfaces are among
///    them, as the tetrahedra of the lesser label have them;
///  - for each axis and each plane the triangles between the tetrahedra below and
///    those above, turning left from above: number, points, region below (as
///    above), region above less region below, worst angle below, worst angle above.
struct Scene {
  std::string data;
  Box box{};
  Planes planes;
  std::uint64_t border_faces = 0;       ///< of the mesh
  std::uint64_t interface_faces = 0;    ///< of the mesh
  std::uint64_t surface_triangles = 0;  ///< of the scene: fewer where it is coarser
  double coarse = 0;                    ///< the side of the cells that points were drawn
                                        ///< together in; 0 if they were not
  std::uint64_t cut_triangles = 0;
};

/// The mesh must have a tetrahedron with four corners.
Scene make_scene(const FileMesh& mesh, const Regions& regions, const SceneLimits& limits);

}  // namespace certet::view
