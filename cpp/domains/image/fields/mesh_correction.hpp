#pragma once
/// \file
/// Constants corrected by what the mesh of a lattice has of small regions.

#include <functional>
#include <memory>

#include "certet/context.hpp"
#include "certet/image.hpp"
#include "fields/label_fields.hpp"
#include "fields/node_fields.hpp"
#include "placement.hpp"

namespace certet::fields {

/// Fields on a lattice.
using DomainOf =
    std::function<std::unique_ptr<InterfaceDomain>(std::shared_ptr<const NodeFields> nodes)>;

/// The fields for a lattice.  Cut edges that are cut straight, cuts that are kept away from
/// vertices and vertices that move change the volumes of small regions by more than fields
/// do: where that is by more than 0.8 %, their constants are changed, five times at most, and
/// the best are taken.  Only regions of 1,000 to 5,000 voxels are measured, and up to 12,000 where
/// they are thin or their constants great, for others are seldom off by as much; and only where
/// a cell of the lattice is no larger than a voxel.
/// \throws Error `cancelled`.
std::shared_ptr<const NodeFields> corrected_by_mesh(std::shared_ptr<const LabelFields> fields,
                                                    const Placement& placement,
                                                    const DomainOf& domain_of,
                                                    const Context& context);

}  // namespace certet::fields
