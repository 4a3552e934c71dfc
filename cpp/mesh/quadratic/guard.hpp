#pragma once
/// \file
/// Which middle nodes must stay so that no element is spoilt.

#include <cstdint>
#include <span>
#include <vector>

#include "certet/context.hpp"
#include "surface_edges.hpp"

namespace certet::quadratic {

/// Takes those bends back of which an element's Jacobian determinant could fall below a
/// `least_jacobian_divisor`th of what it is while straight: of each such element the greatest,
/// of the greatest the one of the least number; then it looks again.  All elements are looked at
/// before any bend is taken back, so that their order does not matter.
/// `bends` are by growing numbers.  \returns a lower bound on what is left of the determinant.
double take_back_spoiling(std::span<const SurfaceElement> elements, std::vector<Bend>& bends,
                          Context& context);

}  // namespace certet::quadratic
