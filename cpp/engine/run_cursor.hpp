#pragma once
/// \file
/// A walk along a row of vertices that numbers their runs.

#include <algorithm>
#include <bit>
#include <cstdint>

#include "sign_planes.hpp"

namespace certet::core {

/// The bits at which runs of set bits begin, seen from a word of a row and the one before.
constexpr std::uint64_t run_starts(std::uint64_t word, std::uint64_t before) {
  return word & ~(word << 1 | before >> 63);
}

/// Goes along a row, from its first word on, and numbers the runs on the way.
class RunCursor {
 public:
  /// Of a row's plus vertices and of those that begin runs, as seen from vertices whose
  /// index is `shift` smaller.  `first` is the number of the row's first run.
  RunCursor(const std::uint64_t* plus, const std::uint64_t* starts, int shift,
            std::uint32_t first)
      : plus_row_(plus), starts_row_(starts), shift_(shift),
        next_(first + (shift > 0 ? static_cast<std::uint32_t>(starts[0] & 1) : 0)) {}

  /// The plus vertices of the next word.
  std::uint64_t next(int w) {
    next_ += static_cast<std::uint32_t>(std::popcount(starts_));
    starts_ = shifted(starts_row_, w, shift_);
    return plus_ = shifted(plus_row_, w, shift_);
  }
  /// Those of the word that begin a run.
  [[nodiscard]] std::uint64_t starts() const { return starts_; }
  /// The run of a plus vertex of the word.
  [[nodiscard]] std::uint32_t run(int b) const {
    return next_ + static_cast<std::uint32_t>(std::popcount(starts_ << (63 - b))) - 1;
  }
  /// That vertex and those of its run that follow in the word.
  [[nodiscard]] std::uint64_t rest_of_run(int b) const {
    const int next = std::countr_zero(starts_ >> b & ~std::uint64_t{1});
    const int length = std::min(std::countr_one(plus_ >> b), next);
    return length == 64 ? plus_ : below(length) << b;
  }

 private:
  const std::uint64_t *plus_row_, *starts_row_;
  int shift_;
  std::uint64_t plus_ = 0, starts_ = 0;
  std::uint32_t next_;  ///< the first run that begins in the word or later
};

}  // namespace certet::core
