#include "row_ranks.hpp"

namespace certet::core {

void RowRanks::compute(const SignPlanes& planes, int j, int k) {
  words_ = planes.words();
  entries_.resize(static_cast<std::size_t>(words_ * kind_count));
  for (int w = 0; w < words_; ++w) {
    Entry* const entry = &entries_[static_cast<std::size_t>(w * kind_count)];
    const std::array<SignWord, grid_count> own{
        SignWord{planes.plus(even, j, k)[w], planes.zero(even, j, k)[w]},
        SignWord{planes.plus(odd, j, k)[w], planes.zero(odd, j, k)[w]}};
    entry[even].mask = own[even].plus | own[even].zero;
    entry[odd].mask = own[odd].plus | own[odd].zero;
    for (int f = 0; f < family_count; ++f) {
      const SignWord first = own[families[f].first.grid];
      const SignWord second = signs_at(planes, families[f].second, j, k, w);
      entry[corner_kinds + f].mask =
          (first.plus & second.minus()) | (first.minus() & second.plus);
    }
  }
  count_ = 0;
  for (int kind = 0; kind < kind_count; ++kind) {
    if (kind == corner_kinds) corners_ = count_;
    for (int w = 0; w < words_; ++w) {
      Entry& entry = entries_[static_cast<std::size_t>(w * kind_count + kind)];
      entry.before = count_;
      count_ += static_cast<std::uint32_t>(std::popcount(entry.mask));
    }
  }
}

}  // namespace certet::core
