#include "hold.hpp"

#include <algorithm>
#include <array>

namespace certet::fields {
namespace {

using OfNodes = std::array<std::int32_t, nodes_of_block>;

/// How far the own label is to be mixed in, and what is to be added to it then.
struct Hold {
  OfNodes mixing, more;
};

/// Where a sheet lies along the axes, its surface is at the faces of voxels with the first of
/// these, and so are points of a lattice: the second keeps them within it.
constexpr std::int32_t flat_lead = 5 * field_one / 8, beyond_faces = field_one / 64;
/// 16 bits hold it.
constexpr std::int32_t greatest_value = 2 * field_one - 1;

/// By how much constants lower the own label of a node against the best of the others.
std::int32_t lowered(const BlockView& block, std::span<const std::int32_t> values,
                     const Constants& constants, std::size_t node) {
  const std::size_t own = block.nodes[node].own();
  const auto constant = [&](std::size_t l) {
    return constants[static_cast<std::size_t>(block.materials[l])];
  };
  std::int32_t best = 0, of_best = constant(own);
  for (std::size_t l = 0; l < block.labels; ++l)
    if (const std::int32_t value = values[l * nodes_of_block + node]; l != own && value > best) {
      best = value;
      of_best = constant(l);
    }
  return std::max(0, of_best - constant(own));
}

/// Mixing gives a lead of 1 at most.
void find_hold(const BlockView& block, const Constants& constants,
               std::span<const std::int32_t> values, Hold& hold) {
  OfNodes best_other{};
  const std::int32_t* value = values.data();
  for (std::size_t l = 0; l < block.labels; ++l, value += nodes_of_block)
    for (std::size_t n = 0; n < nodes_of_block; ++n)
      best_other[n] = std::max(best_other[n], block.nodes[n].own() == l ? 0 : value[n]);
  for (std::size_t n = 0; n < nodes_of_block; ++n) {
    const Node& node = block.nodes[n];
    const std::int32_t ahead = best_other[n] - values[node.own() * nodes_of_block + n];
    std::int32_t lead = node.lead();
    if (const std::int32_t low = node.firm() ? lowered(block, values, constants, n) : 0; low > 0)
      lead = std::clamp(std::min(lead, flat_lead) + beyond_faces + low, lead,
                        std::max(lead, greatest_value - best_other[n]));
    const std::int32_t mixed = std::min(lead, field_one);
    hold.mixing[n] = ahead <= -mixed ? 0 : ((mixed + ahead) << field_bits) / (field_one + ahead);
    hold.more[n] = std::max(0, lead - std::max(mixed, -ahead));
  }
}

}  // namespace

void raise_and_hold(const BlockView& block, const Constants& constants, bool hold,
                    std::span<std::int32_t> out) {
  std::size_t i = 0;
  for (std::size_t l = 0; l < block.labels; ++l) {
    const std::int32_t constant = constants[static_cast<std::size_t>(block.materials[l])];
    for (std::size_t n = 0; n < nodes_of_block; ++n, ++i)
      out[i] = block.values[i] == 0 ? 0 : block.values[i] + constant;
  }
  if (!hold) return;
  Hold found;
  find_hold(block, constants, out, found);
  i = 0;
  for (std::size_t l = 0; l < block.labels; ++l)
    for (std::size_t n = 0; n < nodes_of_block; ++n, ++i)
      out[i] += (block.nodes[n].own() == l ? found.mixing[n] + found.more[n] : 0) -
                ((out[i] * found.mixing[n]) >> field_bits);
}

}  // namespace certet::fields
