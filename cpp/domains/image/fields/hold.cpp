#include "hold.hpp"

#include <algorithm>
#include <cstring>
#include <span>

namespace certet::fields {
namespace {

/// Where a sheet lies along the axes, its surface is at the faces of voxels with the first of
/// these, and so are points of a lattice: the second keeps them within it.
constexpr std::int32_t flat_lead = 5 * field_one / 8, beyond_faces = field_one / 64;
/// 16 bits hold it.
constexpr std::int32_t greatest_value = 2 * field_one - 1;

/// Of the own label, and the greatest of the others and 0.
struct Best {
  OfNodes own, other;
};

/// Loops of 16 bits, which compilers make vectors of.
void raise(const BlockView& block, const Constants& constants, HeldBlock& out, Best& best) {
  best.own.fill(0);
  best.other.fill(0);
  const std::int16_t* value = block.values;
  std::int16_t* raised = out.values.data();
  for (std::size_t l = 0; l < block.labels;
       ++l, value += nodes_of_block, raised += nodes_of_block) {
    const auto constant = static_cast<std::int16_t>(
        constants[static_cast<std::size_t>(block.materials[l])]);
    const auto label = static_cast<std::int16_t>(l);
    for (std::size_t n = 0; n < nodes_of_block; ++n) {
      const auto sum = static_cast<std::int16_t>(value[n] + constant);
      const std::int16_t here = value[n] == 0 ? std::int16_t{0} : sum;
      const bool is_own = out.own[n] == label;
      raised[n] = here;
      best.own[n] = is_own ? here : best.own[n];
      best.other[n] = std::max(best.other[n], is_own ? std::int16_t{0} : here);
    }
  }
  for (std::size_t n = 0; n < nodes_of_block; ++n) {
    const auto own = std::max(best.own[n], std::int16_t{0});
    const auto margin = static_cast<std::int16_t>(own - best.other[n]);
    out.margins[n] = std::max(margin, std::int16_t{0});
  }
}

/// By how much constants lower the own label of a node against the best of the others.
std::int32_t lowered(const BlockView& block, std::span<const std::int16_t> values,
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

/// How far the own label is to be mixed in, and what is to be added to it then.
struct Hold {
  std::int32_t mixing, more;
};

/// Mixing gives a lead of 1 at most.
Hold find_hold(const BlockView& block, const Constants& constants, const HeldBlock& raised,
               const Best& best, std::size_t n) {
  const Node& node = block.nodes[n];
  const std::int32_t ahead = best.other[n] - best.own[n];
  std::int32_t lead = node.lead();
  if (const std::int32_t low = node.firm() ? lowered(block, raised.values, constants, n) : 0;
      low > 0)
    lead = std::clamp(std::min(lead, flat_lead) + beyond_faces + low, lead,
                      std::max(lead, greatest_value - best.other[n]));
  const std::int32_t mixed = std::min(lead, field_one);
  return {ahead <= -mixed ? 0 : ((mixed + ahead) << field_bits) / (field_one + ahead),
          std::max(0, lead - std::max(mixed, -ahead))};
}

void hold_node(const BlockView& block, const Hold& hold, std::size_t n, HeldBlock& out) {
  const std::size_t own = block.nodes[n].own();
  std::int32_t of_own = 0, best_other = 0;
  for (std::size_t l = 0; l < block.labels; ++l) {
    std::int16_t& kept = out.values[l * nodes_of_block + n];
    const std::int32_t value = kept + (own == l ? hold.mixing + hold.more : 0) -
                               ((kept * hold.mixing) >> field_bits);
    kept = static_cast<std::int16_t>(value);
    if (own == l) of_own = value;
    else best_other = std::max(best_other, value);
  }
  out.margins[n] = static_cast<std::int16_t>(std::max(0, of_own - best_other));
}

/// A flag for each node, and no more than fill whole words.
using Flags = std::array<std::uint8_t, (nodes_of_block + 7) / 8 * 8>;

/// Nodes whose own label is ahead by less than their lead, or by less than constants make it.
bool find_unheld(const BlockView& block, const OfNodes& margins, Flags& unheld) {
  unheld.fill(0);
  unsigned some = 0;
  for (std::size_t n = 0; n < nodes_of_block; ++n) {
    // The firm bit is above all margins.
    const bool is = static_cast<std::uint16_t>(margins[n]) < block.nodes[n].lead_bits;
    unheld[n] = is ? 1 : 0;
    some |= unheld[n];
  }
  return some != 0;
}

/// Calls visit(n) for each flag that is set.
template <class Visit>
void for_each_set(const Flags& flags, const Visit& visit) {
  for (std::size_t n = 0; n < flags.size(); n += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, &flags[n], 8);
    if (word == 0) continue;
    for (std::size_t i = n; i < n + 8; ++i)
      if (flags[i] != 0) visit(i);
  }
}

}  // namespace

void raise_and_hold(const BlockView& block, const Constants& constants, bool hold,
                    HeldBlock& out) {
  for (std::size_t n = 0; n < nodes_of_block; ++n)
    out.own[n] = static_cast<std::int16_t>(block.nodes[n].own());
  out.values.resize(block.labels * nodes_of_block);
  Best best;
  raise(block, constants, out, best);
  Flags unheld;
  if (!hold || !find_unheld(block, out.margins, unheld)) return;
  for_each_set(unheld, [&](std::size_t n) {
    const Hold found = find_hold(block, constants, out, best, n);
    if ((found.mixing | found.more) != 0) hold_node(block, found, n, out);
  });
}

}  // namespace certet::fields
