#pragma once
/// \file
/// A picture of a mesh, drawn without a display.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "certet/formats.hpp"

namespace certet {

/// What a picture shows.
enum class PictureView {
  both,     ///< the surface on the left, the cut mesh on the right
  surface,  ///< the mesh from outside
  cut,      ///< without what is on the near side of a plane
};

/// What the colour of a tetrahedron, or of its face, says.
enum class PictureColor {
  region,  ///< its label
  angle,   ///< TetShape::worst_angle
  distance,  ///< of the surface from a shape, with a legend
};

/// How far points of the world are from a shape, in the order of the points.
using DistancesFrom = std::function<std::vector<double>(std::span<const Point3>)>;

/// How a mesh is cut open.
enum class PictureCut {
  automatic,  ///< flat where there are several regions and colours tell them apart, else whole
  whole,      ///< whole tetrahedra are taken away, by their centroids
  flat,       ///< at the plane, through tetrahedra
};

struct PictureOptions {
  int width = 1600, height = 800;  ///< pixels, 16 to 8192
  PictureView view = PictureView::both;
  PictureColor color = PictureColor::region;
  PictureCut cut = PictureCut::automatic;
  int axis = 0;           ///< that the plane is orthogonal to: 0, 1 or 2
  DistancesFrom distances = {};  ///< for `PictureColor::distance`
  double fraction = 0.5;  ///< where the plane is, from the low end of the mesh to the high
};

/// Rows from the top, three bytes (red, green, blue in sRGB) for each pixel.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Draws a mesh, with lines where regions of different colours meet; tetrahedra that lack a
/// corner are left out.  The same bytes for
/// the same mesh.
/// \throws Error `bad_option` for a size, axis or fraction out of range, or colours without distances,
/// `empty_domain` where nothing is to be seen.
Picture draw(const FileMesh& mesh, const PictureOptions& options);

/// Whether PNG was built in.
bool can_write_png();

/// \throws Error `write_failed`; then there is no new file.
void write_png(const Picture& picture, const std::filesystem::path& file);

}  // namespace certet
