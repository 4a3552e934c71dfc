#pragma once
/// \file
/// Which labels there are, and their ranks, which are materials.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "certet/domain.hpp"

namespace certet {

/// Collects different labels among many.  Those seen lately are not kept again.
class LabelCollector {
 public:
  LabelCollector() { lately_.fill(std::numeric_limits<std::int64_t>::min()); }

  void add(std::int64_t label) {
    std::int64_t& slot = lately_[static_cast<std::uint64_t>(label) % lately_.size()];
    if (slot == label) return;
    slot = label;
    labels_.push_back(static_cast<std::int32_t>(label));
    if (labels_.size() > limit_) sort();
  }

  /// Ascending.
  std::vector<std::int32_t> finish() {
    sort();
    return std::move(labels_);
  }

 private:
  void sort() {
    std::ranges::sort(labels_);
    labels_.erase(std::unique(labels_.begin(), labels_.end()), labels_.end());
    limit_ = 2 * labels_.size() + lately_.size();
  }

  std::array<std::int64_t, 4096> lately_;
  std::vector<std::int32_t> labels_;
  std::size_t limit_ = 4096;
};

/// Materials of labels: the first label is material 1.
class MaterialTable {
 public:
  /// `labels` are ascending.
  explicit MaterialTable(std::vector<std::int32_t> labels) : labels_(std::move(labels)) {
    if (labels_.empty() || std::int64_t{labels_.back()} - labels_.front() >= most_tabled) return;
    table_.resize(static_cast<std::size_t>(labels_.back() - labels_.front()) + 1, 0);
    for (std::size_t m = 0; m < labels_.size(); ++m)
      table_[static_cast<std::size_t>(labels_[m] - labels_.front())] =
          static_cast<Material>(m) + 1;
  }

  [[nodiscard]] std::span<const std::int32_t> labels() const { return labels_; }

  /// The material of a label that there is.
  [[nodiscard]] Material of(std::int64_t label) const {
    if (!table_.empty()) return table_[static_cast<std::size_t>(label - labels_.front())];
    return static_cast<Material>(std::ranges::lower_bound(labels_, label) - labels_.begin()) + 1;
  }

  [[nodiscard]] std::uint64_t bytes() const {
    return labels_.size() * sizeof(labels_[0]) + table_.size() * sizeof(table_[0]);
  }

 private:
  static constexpr std::int64_t most_tabled = 1 << 16;

  std::vector<std::int32_t> labels_;
  std::vector<Material> table_;  ///< by label, from the first; empty if they are far apart
};

}  // namespace certet
