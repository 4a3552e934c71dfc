#include "hold.hpp"

#include <algorithm>
#include <array>

namespace certet::fields {
namespace {

/// By how much the own label is ahead at least, and near thin voxels.
constexpr std::int32_t least_lead = field_one / 64, thin_lead = field_one / 4;

/// How far the own label is to be mixed in where the best other one is `ahead` of it.
std::int32_t mixing_of(std::int32_t ahead, bool thin) {
  const std::int32_t lead = thin ? thin_lead : least_lead;
  return ahead <= -lead ? 0 : ((lead + ahead) << field_bits) / (field_one + ahead);
}

using OfNodes = std::array<std::int32_t, nodes_of_block>;

/// How far the own label is to be mixed in.
void find_mixing(const BlockView& block, std::span<const std::int32_t> values, OfNodes& mixing) {
  OfNodes best_other{};
  const std::int32_t* value = values.data();
  for (std::size_t l = 0; l < block.labels; ++l, value += nodes_of_block)
    for (std::size_t n = 0; n < nodes_of_block; ++n)
      best_other[n] = std::max(best_other[n], block.nodes[n].own() == l ? 0 : value[n]);
  for (std::size_t n = 0; n < nodes_of_block; ++n) {
    const std::int32_t ahead = best_other[n] - values[block.nodes[n].own() * nodes_of_block + n];
    mixing[n] = mixing_of(ahead, block.nodes[n].thin());
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
  OfNodes mixing;
  find_mixing(block, out, mixing);
  i = 0;
  for (std::size_t l = 0; l < block.labels; ++l)
    for (std::size_t n = 0; n < nodes_of_block; ++n, ++i)
      out[i] += (block.nodes[n].own() == l ? mixing[n] : 0) - ((out[i] * mixing[n]) >> field_bits);
}

}  // namespace certet::fields
