#pragma once
/// \file
/// How large regions are.

#include <array>
#include <cstdint>
#include <vector>

#include "certet/context.hpp"
#include "fields/node_fields.hpp"

namespace certet::fields {

/// Of every material, in 64ths of a voxel: the points of 4 x 4 x 4 in each cell that have
/// it and lie in an image of so many voxels; voxels at risk may be forced to keep their
/// label.  \throws Error `cancelled`.
std::vector<std::uint64_t> region_volumes(const NodeFields& fields,
                                          const std::array<std::int64_t, 3>& size, bool force,
                                          const Context& context);

}  // namespace certet::fields
