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
  angles,     ///< the widest angles that warping is proven to leave
  embedding,  ///< the warped lattice never folds, so that the mesh embeds
  midpoint,   ///< no vertex is warped: the best angles, and steps where the surface is flat
};

/// What a theorem promises of a mesh, in degrees.
struct AngleBounds {
  double min_dihedral, max_dihedral;
  std::string_view theorem;  ///< its name in coq/Certificate.v
};

/// What a method does, and what its theorem promises.
struct MethodFacts {
  Method method;
  std::string_view name;
  Cuts cuts;
  Thresholds thresholds;  ///< at which a cut violates a vertex
  AngleBounds bounds;
  std::string_view sentence;  ///< the method in half a line, for people
};

/// A row for each method, in the order of the enumeration.
inline constexpr std::array<MethodFacts, 3> methods{{
    {Method::angles, "angles", Cuts::bisect, angle_thresholds,
     {10.77, 164.76, "DihedralBounds"},
     "cuts on the surface, thresholds of the widest angles"},
    {Method::embedding, "embedding", Cuts::bisect, embedding_thresholds,
     {9.27, 161.46, "DihedralBoundsEmbedding"},
     "cuts on the surface, thresholds by which the lattice never folds"},
    {Method::midpoint, "midpoint", Cuts::midpoint, no_warp_thresholds,
     {30, 135, "MidpointBounds"},
     "cuts in the middle of edges, no vertex is warped"},
}};

constexpr const MethodFacts& facts(Method method) {
  return methods[static_cast<std::size_t>(method)];
}
constexpr std::string_view name(Method method) { return facts(method).name; }

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
