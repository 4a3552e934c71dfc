#pragma once
/// \file
/// Grouping by counting: the lean way to bring together what belongs together.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/buffer.hpp"

namespace certet::core {

/// Keys in groups that are numbered from 0.  First every key's group is
/// counted, then memory is laid out, then the keys are placed in any order.
template <class Key>
class Groups {
 public:
  explicit Groups(std::size_t groups) : ends_(groups, 0) {}

  void count(std::size_t group, std::uint64_t keys = 1) { ends_[group] += keys; }

  void lay_out() {
    std::uint64_t begin = 0;
    for (std::uint64_t& end : ends_) {
      const std::uint64_t size = end;
      end = begin;  // moves to the end while keys are placed
      begin += size;
    }
    keys_ = Buffer<Key>(begin);
  }

  void place(std::size_t group, const Key& key) { keys_[ends_[group]++] = key; }

  [[nodiscard]] std::size_t size() const { return ends_.size(); }

  /// The keys of a group, when all are placed.
  [[nodiscard]] std::span<Key> operator[](std::size_t group) {
    const std::uint64_t begin = group == 0 ? 0 : ends_[group - 1];
    return {keys_.data() + begin, ends_[group] - begin};
  }

 private:
  std::vector<std::uint64_t> ends_;
  Buffer<Key> keys_;
};

/// Calls work(run) for each run of equals in a sorted range.
template <class Key, class Same, class Work>
void for_runs(std::span<Key> keys, Same same, Work work) {
  for (std::size_t begin = 0; begin < keys.size();) {
    std::size_t end = begin + 1;
    while (end < keys.size() && same(keys[begin], keys[end])) ++end;
    work(keys.subspan(begin, end - begin));
    begin = end;
  }
}

/// Sorts a group: most have a few dozen keys.
template <class Key>
void sort_group(std::span<Key> keys) {
  constexpr std::size_t few = 48;
  if (keys.size() > few) {
    std::sort(keys.begin(), keys.end());
    return;
  }
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const Key key = keys[i];
    std::size_t j = i;
    for (; j > 0 && key < keys[j - 1]; --j) keys[j] = keys[j - 1];
    keys[j] = key;
  }
}

}  // namespace certet::core
