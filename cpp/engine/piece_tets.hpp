#pragma once
/// \file
/// How many tetrahedra each piece of a mesh has.

#include <cstdint>
#include <vector>

#include "joined_parts.hpp"

namespace certet::core {

/// The sets' numbers, from 0 on, by their least elements: of each element, the number of
/// its set.
struct NumberedSets {
  std::vector<std::uint32_t> of;
  std::uint32_t count = 0;
};
NumberedSets number_sets(DisjointSets& sets);

/// Of each of the pieces that make the parts a whole, as they are numbered.
std::vector<std::uint64_t> count_tets_of_pieces(const MeshParts& parts,
                                                const NumberedSets& pieces, Context& context);

}  // namespace certet::core
