#pragma once
/// \file
/// The pieces of a mesh, for people and for programs.

#include "certet/pieces.hpp"
#include "json.hpp"

namespace certet::command {

/// "3 by faces, 2 by vertices; the largest has 98.2 % of the tetrahedra"
std::string sentence(const Pieces& pieces, std::uint64_t tets);
/// Of a surface that is no manifold: how many faults, and where the first one is.
std::string sentence(const SurfaceFaults& faults);

/// Puts the keys `pieces` and `nonmanifold` into an object.
void add_pieces(Json& json, const Pieces& pieces);

}  // namespace certet::command
