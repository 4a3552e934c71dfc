#pragma once
/// \file
/// Patches of the boundary that get names of their own, and how large patches are.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "certet/context.hpp"
#include "certet/frame.hpp"
#include "certet/patch.hpp"
#include "certet/stuffing.hpp"
#include "certet/survey.hpp"

namespace certet {

/// Where a point of the mesh, of its boundary at least, lies in the world.
using PlaceOf = std::function<Point3(std::uint64_t point)>;

/// The points of the boundary of a counted mesh, as they go out.
class BoundaryPoints {
 public:
  /// `moved` are all points of the mesh where some have moved, else empty.
  /// \throws Error `cancelled`.
  BoundaryPoints(const Survey& survey, const Stuffing& stuffing, const Frame& frame,
                 std::span<const Coord3> moved, Context& context);

  /// Of a point that has a face of the boundary.
  [[nodiscard]] Point3 at(std::uint64_t point) const;

 private:
  std::vector<std::uint64_t> numbers_;  ///< growing
  std::vector<Point3> places_;
};

/// Puts faces of the boundary into patches that the user names, behind those that are there.  A
/// choice that names a patch takes all of its faces.  One that names a plane takes those whose
/// corners are all within half a long edge of it, and whose normals within 60 degrees of its own,
/// on either side: as rough as the surface of a lattice may be that has not been cut by the plane.
/// Of several choices the last one has a face.  `size` is the long edge in the world.
/// \throws Error `bad_option`, with one sentence, for a choice that has no faces, or whose faces
/// later ones have all of, and for two of one name.
void name_patches(Survey& survey, std::span<const PatchChoice> choices, double size,
                  const PlaceOf& place);

/// What a patch is called in a survey.
std::string name_of(Patch patch, const Survey& survey);

/// A patch, as large as it is.
struct PatchFigures {
  std::string name;
  std::uint64_t triangles = 0;
  double area = 0;  ///< in units of the world, squared
};

/// Of all patches that have faces, in their order.  Areas are added face by face, by growing
/// numbers of points.
std::vector<PatchFigures> patch_figures(const Survey& survey, const PlaceOf& place);

}  // namespace certet
