#pragma once
/// \file
/// Which way the surface of a solid faces, of which signs alone are known.

#include <optional>
#include <span>
#include <vector>

#include "certet/context.hpp"
#include "rays.hpp"

namespace certet::features {

/// About on the surface, and about which way out.
struct Look {
  Vector place, axis;
};

struct Facing {
  Vector place;      ///< on the surface
  Vector normal;     ///< of length 1, outward
  bool smooth;       ///< whether the surface faces the same way all around, within a 128th of an
                     ///< edge; else the normal is that of one of the faces there
};

/// What is seen there; nothing where it is no surface that rays along the axis pass.
std::vector<std::optional<Facing>> facing(const Domain& domain, std::span<const Look> looks,
                                          Context& context);

/// In degrees.
double angle_between(const Vector& a, const Vector& b);

/// Of length 1, or 0.
Vector unit(const Vector& a);

/// Two directions at right angles to an axis and each other, so that a turn from one to the other
/// is anticlockwise seen from where the axis points.
std::array<Vector, 2> across(const Vector& axis);

}  // namespace certet::features
