#pragma once
/// \file
/// Sharp edges and corners of a surface, and a mesh whose vertices move onto them.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "certet/context.hpp"
#include "certet/mesh.hpp"
#include "certet/placed_domain.hpp"

namespace certet {

/// Between the normals of two triangles, in degrees: their edge is sharp if theirs are farther
/// apart.
inline constexpr double usual_feature_angle = 40;

/// An edge between two triangles whose normals differ by more than was asked for; the triangle
/// that runs from `from` to `to` is on its left.
struct FeatureEdge {
  Coord3 from, to;            ///< steps
  std::uint32_t left, right;  ///< patches
};

/// Where a surface is not smooth.
struct Features {
  std::vector<TriangleCorners> triangles;  ///< of the surface, steps
  std::vector<std::uint32_t> patches;  ///< of triangles: those of one are joined across smooth edges
  std::vector<FeatureEdge> edges;
  std::vector<Coord3> corners;  ///< where sharp edges end, branch or turn by more than 40 degrees

  [[nodiscard]] bool none() const { return edges.empty(); }
};

/// Of triangles that share their points.  An edge of other than two triangles is sharp; a triangle
/// thinner than what rounding to steps leaves a normal of has that of its neighbour.
/// \throws Error `bad_option` (an angle that is not from 1 to 179 degrees).
Features features_of(std::span<const TriangleCorners> triangles, double angle);

/// Of the facets of a domain, without the edges that are within it, as where solids overlap.
/// \throws Error as that; what the domain throws.
Features features_of(const PlacedDomain& domain, double angle);

/// The sharp edges of any domain, found by where its surface turns between vertices of its mesh: the
/// edges and corners of parts that meet, and the rim where it is cut off; of what samples of a grid
/// tell of that rim alone.  To a few steps where faces are flat or little bent.  Without triangles;
/// patches are those of the mesh's vertices.  An edge that no edge of the mesh crosses is not found.
/// The result does not depend on the number of threads.
/// \throws Error `cancelled`, `too_large` (out of memory), `bad_option` as the others; what the domain
/// throws.
Features features_of(const Mesh& mesh, const PlacedDomain& domain, double angle, Context& context);

/// How the edges of a surface are, by their lengths.
struct Creases {
  double flat = 0;       ///< share whose normals differ by 20 degrees at most
  double sharp = 0;      ///< share whose normals differ by more than 40
  double loose_ends = 0; ///< of the points of sharp edges, the share that only one of them has

  /// Whether the surface is that of a part which somebody drew: at least nine tenths of the edges
  /// are flat or sharp, some are sharp, and at most a tenth of the sharp ones' points are ends.
  [[nodiscard]] bool are_drawn() const {
    return sharp > 0 && flat + sharp >= 0.9 && loose_ends <= 0.1;
  }
};
Creases creases_of(std::span<const TriangleCorners> triangles);

/// What is asked for.
struct FeatureChoice {
  bool automatic = true;        ///< by `usual_feature_angle`, where a surface was drawn
  std::optional<double> angle;  ///< degrees; neither: vertices stay
};

/// Whether vertices are to move onto sharp edges, and why.
struct FeatureDecision {
  std::optional<double> angle;     ///< of sharp edges, degrees; nothing: vertices stay
  std::optional<Creases> creases;  ///< of a shape whose faces are known
  std::string why;                 ///< the end of a sentence
};

/// Decides by the facets of a domain; where there are none, only an angle has sharp edges looked for.
/// \throws Error `bad_option` where an angle is asked for that makes no sense, or of cuts in the
/// middle of edges.
FeatureDecision decide_features(const FeatureChoice& choice, const PlacedDomain& domain,
                                Method method);

/// A feature counts as kept where edges of the mesh's surface are no farther than this, in long
/// edges.
inline constexpr double kept_distance = 0.02;

/// How much of the features a mesh has.  Where these are bent, edges that follow them miss them by
/// what a chord does.
struct FeatureFigures {
  double length = 0;       ///< of all sharp edges, in long edges
  double followed_length = 0;  ///< of what is between two vertices exactly on it, joined by an edge
  double kept_length = 0;  ///< of that, what these edges are within `kept_distance` of
  double greatest_distance = 0;  ///< of a sharp edge from the edges of the mesh's surface, in long edges
  std::uint64_t corners = 0, kept_corners = 0;  ///< the latter have a vertex exactly there
  std::uint64_t moved = 0;                      ///< vertices
  double greatest_move = 0;                     ///< in long edges

  [[nodiscard]] double followed_percent() const { return percent(followed_length); }
  [[nodiscard]] double kept_percent() const { return percent(kept_length); }
  [[nodiscard]] bool all_followed() const {
    return kept_corners == corners && followed_length >= length * (1 - 1e-9);
  }

  [[nodiscard]] double percent(double part) const {
    return length > 0 ? 100 * part / length : 100;
  }
};

/// What is not kept, in a sentence; empty if all is.
std::string sentence_on(const FeatureFigures& figures);

/// Moves vertices of the boundary onto corners and sharp edges, and others to make room, so that
/// the edges of the surface run along the features and its other vertices near them lie on the
/// faces between.  A vertex moves only where all tetrahedra around stay positive and within the
/// bounds of the mesh's method, decided in integers: so its theorem's bounds hold still, checked.
/// Numbers of points, tetrahedra and labels stay.  Vertices where the shape is cut off, those of
/// interfaces, and those at which the boundary is no manifold stay where they are.
///
/// The result does not depend on the number of threads: vertices move one after the other.
/// \throws Error `cancelled`, `too_large` (out of memory), `bad_option` (cuts in the middle of
/// edges, whose surface has steps).
FeatureFigures keep_features(Mesh& mesh, const Features& features, Context& context);
inline FeatureFigures keep_features(Mesh& mesh, const Features& features) {
  Context context;
  return keep_features(mesh, features, context);
}

/// The same for all edges of the domain that the mesh was made of, which are sharper than an angle, in
/// degrees: as its facets tell them or, where there are none, as `features_of` finds them.  Then
/// vertices in faces where the shape is cut off move too, along these.
/// \throws Error as that, and as `features_of`.
FeatureFigures keep_features(Mesh& mesh, const PlacedDomain& domain, double angle, Context& context);

}  // namespace certet
