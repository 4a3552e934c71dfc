#pragma once
/// \file
/// How large regions are in a mesh.

#include <cstdint>
#include <vector>

#include "certet/context.hpp"
#include "certet/domain.hpp"
#include "certet/lattice.hpp"

namespace certet::fields {

/// A material, and a part of a lattice that holds its region with some cells around it.
struct RegionPart {
  Material material;
  Lattice lattice;
};

/// What the regions have in a mesh by the default method, in long edges cubed: each
/// part is meshed by itself.
/// \throws Error `cancelled`.
std::vector<double> mesh_volumes(const Domain& domain, const std::vector<RegionPart>& parts,
                                 const Context& context);

}  // namespace certet::fields
