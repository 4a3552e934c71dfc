#pragma once
/// \file
/// The materials around a vertex.

#include <array>
#include <cstddef>
#include <span>

#include "certet/domain.hpp"
#include "link.hpp"

namespace certet::core {

/// Which of a vertex's neighbours are of each material.
class MaterialSets {
 public:
  struct Entry {
    Material material;
    LinkSet set;
  };

  void add(Material material, LinkSet neighbours) {
    std::size_t n = 0;
    while (n < count_ && entries_[n].material != material) ++n;
    if (n == count_) entries_[count_++] = {material, 0};
    entries_[n].set |= neighbours;
  }

  /// In the order in which they were added first.
  [[nodiscard]] std::span<const Entry> entries() const {
    return std::span(entries_).first(count_);
  }

 private:
  std::size_t count_ = 0;
  std::array<Entry, direction_count + 2> entries_;  ///< of the neighbours, and of two more
};

}  // namespace certet::core
