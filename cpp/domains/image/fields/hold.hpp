#pragma once
/// \file
/// Fields of a block, each raised by its label's constant, and the own label of every
/// node made to win there.

#include <array>
#include <cstdint>
#include <vector>

#include "fields/field_tile.hpp"

namespace certet::fields {

/// What is added to the field of a material, by material, in 16384ths.
using Constants = std::vector<std::int32_t>;

/// A number for each node of a block.
using OfNodes = std::array<std::int16_t, nodes_of_block>;

struct HeldBlock {
  OfNodes own;                       ///< the number of each node's label
  std::vector<std::int16_t> values;  ///< one field after the other, as in the block
  OfNodes margins;  ///< how far the own label is ahead of all others and of 0; 0 if behind
};

/// Where the own label's value o is not above the best other value q (0 at least) by the node's
/// lead, values u become (1-m) u, and that of the own label m more, with the m by which it then
/// is; what a lead is above 1 is added to the own label's.  Where constants lower the own label
/// of a firm node against the best other, the lead grows to that much more than 5/8 and 1/64, or
/// than itself and 1/64 if it is less than 5/8.  A value of 0 says that the label is not near,
/// and stays so.
void raise_and_hold(const BlockView& block, const Constants& constants, bool hold, HeldBlock& out);

}  // namespace certet::fields
