#pragma once
/// \file
/// Things that are joined to sets.

#include <cstdint>
#include <numeric>
#include <vector>

namespace certet {

/// Things numbered from 0, each in a set of its own until sets are joined.  Sets that
/// have no thing of a range of numbers may be joined by another thread at the same time.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  [[nodiscard]] std::size_t size() const { return parent_.size(); }

  /// The least of its set.
  std::uint32_t find(std::uint32_t one) {
    while (parent_[one] != one) one = parent_[one] = parent_[parent_[one]];
    return one;
  }
  /// False where they are one set already.
  bool join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    if (a < b) parent_[b] = a;
    else parent_[a] = b;
    return a != b;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace certet
