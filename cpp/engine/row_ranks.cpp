#include "row_ranks.hpp"

namespace certet::core {

namespace {

/// Where the edges owned by the indices of a word are cut: between plus and minus.
std::array<std::uint64_t, family_count> cut_masks(const SignRows& rows, int w) {
  std::array<std::uint64_t, edge_end_count> plus;
  std::array<std::uint64_t, edge_end_count> minus;
  std::uint64_t any_plus = 0;
  std::uint64_t any_minus = 0;
  for (std::size_t n = 0; n < edge_end_count; ++n) {
    const SignWord signs = rows.at(edge_ends.vertices[n], w);
    any_plus |= plus[n] = signs.plus;
    any_minus |= minus[n] = signs.minus();
  }
  std::array<std::uint64_t, family_count> masks{};
  if (any_plus == 0 || any_minus == 0) return masks;
  for (std::size_t f = 0; f < family_count; ++f) {
    const auto [a, b] = edge_ends.of_family[f];
    masks[f] = (plus[a] & minus[b]) | (minus[a] & plus[b]);
  }
  return masks;
}

/// The same where several materials meet: between two of them, or one and the outside.
std::array<std::uint64_t, family_count> parted_masks(const MaterialPlanes& materials,
                                                     const SignRows& rows, int j, int k, int w) {
  std::array<std::uint64_t, family_count> masks = materials.parted(j, k, w);
  for (std::size_t f = 0; f < family_count; ++f) {
    if (masks[f] == 0) continue;
    const SignWord first = rows.at(families[f].first, w);
    const SignWord second = rows.at(families[f].second, w);
    masks[f] &= (first.plus | second.plus) & ~first.zero & ~second.zero;
  }
  return masks;
}

}  // namespace

void RowRanks::compute(const SignPlanes& planes, int j, int k, const GradedCells* graded) {
  words_ = planes.words();
  entries_.assign(static_cast<std::size_t>(words_) * kind_count, {});
  count_ = corners_ = 0;
  if (j < 0 || j >= planes.cells()[1] || !planes.window().contains(k)) return;
  const SignRows rows(planes, j, k);
  const MaterialPlanes* const materials = planes.materials();
  for (int w = 0; w < words_; ++w) {
    Entry* const entry = &entries_[static_cast<std::size_t>(w) * kind_count];
    for (const Grid grid : grids) {
      const SignWord own = rows.at({grid, {}}, w);
      entry[grid].mask = own.plus | own.zero;
      if (graded != nullptr) entry[grid].mask &= graded->used(grid, j, k, w);
    }
    const auto masks = materials == nullptr ? cut_masks(rows, w)
                                            : parted_masks(*materials, rows, j, k, w);
    for (std::size_t f = 0; f < family_count; ++f) entry[corner_kinds + f].mask = masks[f];
  }
  number_entries();
}

void RowRanks::number_entries() {
  count_ = 0;
  for (std::size_t kind = 0; kind < kind_count; ++kind) {
    if (kind == corner_kinds) corners_ = count_;
    for (int w = 0; w < words_; ++w) {
      Entry& entry = entries_[static_cast<std::size_t>(w) * kind_count + kind];
      entry.before = count_;
      count_ += static_cast<std::uint32_t>(std::popcount(entry.mask));
    }
  }
}

}  // namespace certet::core
