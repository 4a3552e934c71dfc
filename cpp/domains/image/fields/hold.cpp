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

/// Mixing gives a lead of 1 at most.
void find_hold(const BlockView& block, std::span<const std::int32_t> values, Hold& hold) {
  OfNodes best_other{};
  const std::int32_t* value = values.data();
  for (std::size_t l = 0; l < block.labels; ++l, value += nodes_of_block)
    for (std::size_t n = 0; n < nodes_of_block; ++n)
      best_other[n] = std::max(best_other[n], block.nodes[n].own() == l ? 0 : value[n]);
  for (std::size_t n = 0; n < nodes_of_block; ++n) {
    const std::int32_t ahead = best_other[n] - values[block.nodes[n].own() * nodes_of_block + n];
    const std::int32_t lead = block.nodes[n].lead, mixed = std::min(lead, field_one);
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
  find_hold(block, out, found);
  i = 0;
  for (std::size_t l = 0; l < block.labels; ++l)
    for (std::size_t n = 0; n < nodes_of_block; ++n, ++i)
      out[i] += (block.nodes[n].own() == l ? found.mixing[n] + found.more[n] : 0) -
                ((out[i] * found.mixing[n]) >> field_bits);
}

}  // namespace certet::fields
