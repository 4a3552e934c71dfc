#pragma once
/// \file
/// The worst angles of all tetrahedra of a mesh, by the squares of their cosines.

#include <cstdint>
#include <span>

#include "certet/buffer.hpp"
#include "certet/context.hpp"
#include "certet/mesh.hpp"

namespace certet::optimising {

struct WorstAngles {
  Buffer<float> of_tets;  ///< the greatest squared cosine of each
  double acute = 0, obtuse = 0;  ///< of the least and the greatest angle of all
};

WorstAngles worst_angles(std::span<const Coord3> points,
                         std::span<const Tet<std::uint32_t>> tets, Context& context);
WorstAngles worst_angles(std::span<const Coord3> points,
                         std::span<const Tet<std::uint64_t>> tets, Context& context);

}  // namespace certet::optimising
