#pragma once
/// \file
/// Things that are joined to sets.

#include <cstdint>
#include <numeric>
#include <vector>

namespace certet {

/// Things numbered from 0, each in a set of its own until sets are joined.  Sets that
/// have no thing of a range of numbers may be joined by another thread at the same time.
template <class Index>
class DisjointSetsOf {
 public:
  explicit DisjointSetsOf(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  [[nodiscard]] std::size_t size() const { return parent_.size(); }

  /// The least of its set.
  Index find(Index one) {
    while (parent_[one] != one) one = parent_[one] = parent_[parent_[one]];
    return one;
  }
  /// False where they are one set already.
  bool join(Index a, Index b) {
    a = find(a), b = find(b);
    if (a < b) parent_[b] = a;
    else parent_[a] = b;
    return a != b;
  }

  /// From now on there are so many things, the new ones each in a set of its own.
  void grow(std::size_t count) {
    while (parent_.size() < count) parent_.push_back(static_cast<Index>(parent_.size()));
  }

  /// Takes a thing out, on condition that all others of its set are taken out too.
  void take_out(Index one) { parent_[one] = one; }

 private:
  std::vector<Index> parent_;
};

using DisjointSets = DisjointSetsOf<std::uint32_t>;

}  // namespace certet
