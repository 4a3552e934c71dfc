#pragma once
/// \file
/// Fields of a block, each raised by its label's constant, and the own label of every
/// node made to win there.

#include <cstdint>
#include <span>
#include <vector>

#include "fields/field_tile.hpp"

namespace certet::fields {

/// What is added to the field of a material, by material, in 16384ths.
using Constants = std::vector<std::int32_t>;

/// `out` has a value for each of the block's.  Where the own label's value o is not above
/// the best other value q (0 at least) by the node's lead, values u become (1-m) u, and that of
/// the own label m more, with the m by which it then is; what a lead is above 1 is added to the
/// own label's.  Where constants lower the own label of a firm node against the best other,
/// the lead grows to that much more than 5/8 and 1/64, or than itself and 1/64 if it is less
/// than 5/8.  A value of 0 says that the label is not near, and stays so.
void raise_and_hold(const BlockView& block, const Constants& constants, bool hold,
                    std::span<std::int32_t> out);

}  // namespace certet::fields
