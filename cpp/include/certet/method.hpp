#pragma once
/// \file
/// How a mesh is made, and the theorem that covers a mesh made that way.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "certet/lattice/warp.hpp"

namespace certet {

/// Where the cuts are put.
enum class Cuts : std::uint8_t {
  bisect,    ///< on the surface, found by bisection to one step
  midpoint,  ///< in the middle of each edge; a vertex on the surface counts as inside
};

constexpr std::string_view name(Cuts cuts) {
  return cuts == Cuts::bisect ? "bisect" : "midpoint";
}

/// The ways to make a mesh, one for each theorem on dihedral angles.
enum class Method : std::uint8_t {
  embedded,   ///< violated vertices settle: the mesh embeds, is a manifold, and keeps the
              ///< pieces, cavities and tunnels of the samples
  angles,     ///< the paper's rule at the thresholds of the widest angles
  embedding,  ///< the paper's rule at those by which the warped lattice never folds
  midpoint,   ///< no vertex is warped: the best angles, and steps where the surface is flat
  key,        ///< as `embedded`, at other thresholds, with diagonals that end at the lesser cut:
              ///< better angles; several materials are meshed by `embedded`
};

/// By which a mesh is made where nobody says how: of several materials that is `embedded`.
inline constexpr Method default_method = Method::key;

/// What a theorem promises of a mesh, in degrees.
struct AngleBounds {
  double min_dihedral, max_dihedral;
  std::string_view theorem;  ///< its name in coq/Certificate.v, or on a page that it exports
};

/// What a method does, and what its theorem promises.
struct MethodFacts {
  Method method;
  std::string_view name;
  Cuts cuts;
  Thresholds thresholds;  ///< at which a cut violates a vertex
  bool settles;           ///< whether a violated vertex may stay; else all move
  bool diagonals_follow_cuts;  ///< whether they end at the lesser cut; else by the Parity Rule
  bool interfaces;        ///< whether several materials are cut where they meet; else only
                          ///< what they are together
  AngleBounds bounds;
  std::string_view sentence;  ///< the method in half a line, for people
};

/// A row for each method, in the order of the enumeration.
inline constexpr std::array<MethodFacts, 5> methods{{
    {Method::embedded, "embedded", Cuts::bisect, angle_thresholds, true, false, true,
     {10.77, 164.76, "SettledBoundsInDegrees"},
     "no tetrahedra overlap, the surface is a manifold, pieces are kept"},
    {Method::angles, "angles", Cuts::bisect, angle_thresholds, false, false, false,
     {10.77, 164.76, "DihedralBounds"},
     "as published, at the thresholds of the widest angles"},
    {Method::embedding, "embedding", Cuts::bisect, embedding_thresholds, false, false, false,
     {9.27, 161.46, "DihedralBoundsEmbedding"},
     "as published, at thresholds by which the lattice never folds"},
    {Method::midpoint, "midpoint", Cuts::midpoint, no_warp_thresholds, false, false, true,
     {30, 135, "MidpointBounds"},
     "cuts in the middle of edges, no vertex is warped"},
    {Method::key, "key", Cuts::bisect, key_thresholds, true, true, true,
     {11.18, 157.13, "CertifiedKeySweptMesh"},
     "diagonals follow the cuts; no tetrahedra overlap, the surface is a manifold, pieces are kept"},
}};

constexpr const MethodFacts& facts(Method method) {
  return methods[static_cast<std::size_t>(method)];
}
constexpr std::string_view name(Method method) { return facts(method).name; }

/// The theorem on angles that covers a mesh and, where materials are cut apart in it, speaks
/// of any number of them; the bounds are the same.
constexpr AngleBounds bounds_of(Method method, bool cut_apart) {
  AngleBounds bounds = facts(method).bounds;
  if (cut_apart)
    bounds.theorem = method == Method::midpoint ? "MaterialMidpointBoundsInDegrees"
                                                : "MaterialDihedralBoundsInDegrees";
  return bounds;
}

/// The method of a name.
constexpr std::optional<Method> method_named(std::string_view name) {
  for (const MethodFacts& row : methods)
    if (row.name == name) return row.method;
  return std::nullopt;
}

/// All names, for sentences.
inline std::string method_names() {
  std::string names;
  for (const MethodFacts& row : methods)
    names.append(names.empty() ? "" : ", ").append(row.name);
  return names;
}

}  // namespace certet
