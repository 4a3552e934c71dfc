#pragma once
/// \file
/// What hangs together, in the plainest way there is: the tests count pieces for themselves.

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t n) {
    while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
    return n;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

  /// How many sets there are among some members.
  template <class Members>
  std::int64_t count(const Members& members) {
    std::set<std::size_t> roots;
    for (const auto& member : members) roots.insert(root(member));
    return static_cast<std::int64_t>(roots.size());
  }

 private:
  std::vector<std::size_t> parent_;
};
