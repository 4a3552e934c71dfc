#pragma once
/// \file
/// From beside a surface onto it.

#include <optional>

#include "certet/domain.hpp"
#include "freedom.hpp"

namespace certet::optimising {

/// Where the surface that a vertex is on passes a position, along the vertex's normal and at most
/// `reach` steps away, to one step: a position on it or, of a surface without any, the nearest
/// one beyond or within.  Nothing where no surface is found, or another one.
std::optional<Coord3> onto_surface(Coord3 position, const Freedom& freedom, double reach,
                                   const Domain& domain);

}  // namespace certet::optimising
