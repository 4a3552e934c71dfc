#pragma once
/// \file
/// Closed surfaces made of triangles, and the solids inside of them.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certet/context.hpp"
#include "certet/pieces.hpp"
#include "certet/placed_domain.hpp"
#include "certet/solid.hpp"

namespace certet {

/// Triangles in space.  Neighbours share the numbers of their points; corners
/// run anticlockwise seen from outside.
struct TriangleSurface {
  std::string name;  ///< what sentences call it: the file
  std::vector<Point3> points;  ///< world coordinates
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< numbers of points
};

/// Whether `read_surface` was built in.
bool can_read_surfaces();

/// Whether the extension is that of a surface: .stl .obj .ply .off.
bool is_surface_file(const std::filesystem::path& file);

/// Reads an STL, OBJ, PLY or OFF file in world coordinates, which are the
/// file's, rounded to 24 bits.  Polygons are cut into triangles, and points that
/// are equal become one.  Counts are checked by the length of the file before
/// memory is taken for them.
/// \throws Error `bad_input` where the file is missing, truncated, not such a
/// file, or has no triangle; the sentence names it.
TriangleSurface read_surface(const std::filesystem::path& file);

/// Makes points that are exactly equal one point, and drops those that belong to
/// no triangle.
/// \throws Error `bad_input` as `inspect`.
void merge_equal_points(TriangleSurface& surface);

/// How often something is wrong, and where first.
struct SurfaceDefect {
  std::uint64_t count = 0;
  Point3 first{0, 0, 0};  ///< world coordinates; of an edge its middle
};

/// Loops of edges around which a surface is open.
struct SurfaceHoles {
  std::uint64_t count = 0;
  double largest = 0;               ///< diagonal of its box, in world units
  std::uint64_t largest_edges = 0;  ///< of the same hole
};

/// What keeps a surface from being the boundary of a solid, or makes it doubtful.
struct SurfaceDefects {
  /// Edges of one triangle: the surface ends there.
  SurfaceDefect open_edges;
  /// What these edges go around.
  SurfaceHoles holes;
  /// Edges of more than two triangles.
  SurfaceDefect overfull_edges;
  /// Those of them with an odd number of triangles: as where two solids share a
  /// wall that is there once.
  SurfaceDefect odd_edges;
  /// Edges of an even number of triangles that do not run along it as often one
  /// way as the other: they do not agree which side is out.
  SurfaceDefect misoriented_edges;
  /// Pairs of triangles of which one has an edge that passes through the other.
  /// Triangles that only touch, as neighbours do, are none.
  SurfaceDefect self_intersections;
  /// All in all the triangles run clockwise seen from outside.
  bool inside_out = false;

  [[nodiscard]] bool closed() const { return open_edges.count == 0 && odd_edges.count == 0; }
};

/// Whether every edge has an even number of triangles, as `SurfaceDefects::closed` has it.
/// \throws Error `bad_input` as `inspect`.
bool is_closed(const TriangleSurface& surface);

/// Edges are counted exactly; intersections are decided exactly for the points
/// rounded to 2^-30 of the longest half side.
/// \throws Error `bad_input` (no triangles, points that are NaN or infinite,
/// numbers of points out of range), `cancelled`.
SurfaceDefects inspect(const TriangleSurface& surface, const Context& context = {});

/// What was done to a surface so that it bounds a solid.
struct SurfaceRepairs {
  /// Corners no farther apart than this, in world units, were taken for one, and
  /// corners no farther from an edge for corners on it; 0: equal ones alone.
  double tolerance = 0;
  std::uint64_t welded_points = 0;         ///< that are gone
  std::uint64_t degenerate_triangles = 0;  ///< dropped: without an area
  std::uint64_t repeated_triangles = 0;    ///< dropped: others had the same corners
  std::uint64_t split_edges = 0;           ///< on which corners of others lie
  std::uint64_t turned_triangles = 0;      ///< that ran the wrong way around
  std::uint64_t inner_triangles = 0;       ///< dropped: walls within the solid, stored once
  /// What the surface is still open around; `open_surface_domain` closes them.
  SurfaceHoles closed_holes;
  std::string name;                        ///< the surface's
};

/// What `repair_surface` may do.
struct RepairChoice {
  bool close_holes = false;  ///< leave them to `open_surface_domain`
};

/// Makes of what exporters write the surface that they mean; a closed surface whose
/// triangles agree stays as it is, but for points that are equal, and triangles that
/// have a point twice or are there several times.
///
/// Equal points become one.  Of triangles that are there several times one is kept,
/// or none where the surface closes without them: a sheet that has both its sides is
/// no wall.  If the surface is then open, points of its open edges are welded, thin
/// triangles there dropped, and edges cut where such points lie on them, with the
/// least tolerance that closes it: 0, and from 1e-9 to 1e-5 of the diagonal of its
/// box, or four times what 24 bits round its coordinates by if that is more.
/// Triangles that run the other way around than their neighbours are turned, the
/// lesser part of each piece.  Where an odd number of three or more triangles meet,
/// space is divided into cells, and a wall between two cells of the solid is dropped:
/// both of its sides are inside.
///
/// With `close_holes` the pieces of an open surface are turned as those of a closed one,
/// those of few triangles that touch no other as the winding number of the others wants, a
/// sheet around which no hole is is dropped, and the holes are counted; they stay, and
/// `open_surface_domain` tells what is inside.
///
/// What is not closed after this stays open: `inspect` tells.
/// \throws Error `bad_input` as `inspect`, `cancelled`.
SurfaceRepairs repair_surface(TriangleSurface& surface, const RepairChoice& choice = {},
                              const Context& context = {});

/// What was done, a sentence each; none if nothing was.
std::vector<std::string> sentences_on(const SurfaceRepairs& repairs);

/// \throws Error `bad_input` where the surface is not closed: a sentence that has the
/// number of its holes and the size of the largest, and `remedy`, which says what
/// would close them.
void refuse_open(const TriangleSurface& surface, const SurfaceDefects& defects,
                 const std::string& remedy);

/// Of an open surface, by the winding numbers on both sides of some thousand triangles:
/// \throws Error `empty_domain` where they are about one half, as beside a flat sheet, and
/// `bad_input` where the solid would be behind many triangles and in front of many others.
void refuse_unclear(const TriangleSurface& surface, const Context& context = {});

/// What the solid inside of a surface measures.
struct SurfaceMeasures {
  /// World units cubed: by the divergence theorem, to rounding, but where the surface
  /// winds around something more than once (solids overlap), or its triangles do not
  /// agree; there by some sixty thousand lines through it.  Of an open one roughly: what
  /// these lines find between its triangles.
  double volume = 0;
  double area = 0;  ///< of the triangles, world units squared
  /// How thick the solid is between faces that are about parallel: of their area, a
  /// fiftieth has this or less.  World units.
  double thin = 0;
};

/// \throws Error as `inspect` and, of an open surface, `open_surface_domain`.
SurfaceMeasures measure(const TriangleSurface& surface, const Context& context = {});

/// How many pieces the solid inside of a closed surface has: its outer shells, since a shell
/// within a solid that faces the other way is a cavity of it.  Parts that have edges or points
/// in common are one piece or several.  Nothing where the surface is open, triangles pass
/// through each other, or shells touch elsewhere; where triangles do not agree which side is
/// out, shells are counted by parity.  `defects` are the surface's, as `inspect` found them.
/// \throws Error as `inspect`.
std::optional<PieceBounds> pieces_of(const TriangleSurface& surface,
                                     const SurfaceDefects& defects, const Context& context = {});

/// For the sake of thin parts, a default goes to no more tetrahedra than about these,
/// and to no more cells of the lattice.
inline constexpr double most_default_tets = 4e6, most_default_cells = 32e6;

/// The long edge that is taken if none is asked for.
struct SurfaceSize {
  /// A 64th of the longest side or, if that is less, a quarter of `SurfaceMeasures::thin`,
  /// as far as `most_default_tets` and `most_default_cells` allow.
  double size = 0;
  double usual = 0;   ///< the 64th
  double wanted = 0;  ///< as if they allowed any number

  [[nodiscard]] bool limited() const { return wanted < size; }
};
SurfaceSize default_size(const TriangleSurface& surface, const SurfaceMeasures& solid);

/// How finely a surface is meshed.
struct SurfaceLattice {
  double size = 0;  ///< long edge in world units; 0: as `default_size`
  std::int32_t margin = 2;  ///< lattice cells around the surface, at least 1
};

/// The solid inside of a closed surface.  The points are rounded to whole steps
/// (a 2^17th of the long edge), and all that follows is exact: there is no
/// distance field, so sharp edges stay sharp, and thin walls that a lattice
/// point falls into are seen.
///
/// Inside is where the surface winds around a point, either way: solids that
/// overlap are united, a shell within another is a cavity if it faces the other
/// way, and a surface that is inside out encloses the same solid.  Where the
/// triangles do not agree which side is out, inside is what an odd number of
/// them separate from the outside.  A point on the surface is on the surface,
/// unless what is next to it on two opposite sides is inside: so it is where
/// solids overlap, and on edges that go inwards.
///
/// The centre of the surface's bounding box is lattice point (0,0,0), and the
/// axes are the world's.
/// \throws Error `bad_input` as `inspect` and where the surface is open,
/// `bad_option` (size, margin), `too_large` (coordinate range).
std::unique_ptr<PlacedDomain> surface_domain(const TriangleSurface& surface,
                                             const SurfaceLattice& lattice);

/// The solid inside of a surface that need not be closed: in the box around it, what it
/// winds around by more than one half, either way.  The winding number is the generalised
/// one, the share of the sphere around a point that the triangles cover, each with its
/// sign (Jacobson, Kavan and Sorkine-Hornung 2013).  A flat hole is closed by its plane,
/// many holes close to each other by what is between; a surface in single triangles with
/// gaps is a solid as if there were none.
///
/// The triangles that a ray meets are counted exactly, as of a closed surface; what the
/// edges add at which the surface ends is a sum of floating point numbers, the same on
/// every machine.  What is one half to a billionth is on the surface.  Where many edges
/// are far away, their sum is near: wrong by less than 0.01.
///
/// A closed surface has the same solid as by `surface_domain`; of another, `refuse_unclear`
/// tells whether the answer makes sense.
/// \throws Error as `surface_domain`, but where the surface is open only if a piece of it
/// has a single side, like a Moebius strip.
std::unique_ptr<PlacedDomain> open_surface_domain(const TriangleSurface& surface,
                                                  const SurfaceLattice& lattice);

/// The solids of `surface_domain` and `open_surface_domain`, to be put on a lattice with
/// others.  Surfaces that have points in common have them where they are rounded to steps,
/// too.  \throws Error as those.
Solid surface_solid(std::shared_ptr<const TriangleSurface> surface);
Solid open_surface_solid(std::shared_ptr<const TriangleSurface> surface);

}  // namespace certet
