#pragma once
/// \file
/// Pairs of boxes that overlap.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "certet/lattice/coord3.hpp"

namespace certet {

struct IntegerBox {
  Coord3 low, high;

  [[nodiscard]] bool meets(const IntegerBox& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
           other.low.y <= high.y && low.z <= other.high.z && other.low.z <= high.z;
  }
  void add(const IntegerBox& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y),
           std::min(low.z, other.low.z)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y),
            std::max(high.z, other.high.z)};
  }
};

/// A binary tree over boxes, halved along the longest axis.
class BoxTree {
 public:
  explicit BoxTree(std::vector<IntegerBox> boxes) : boxes_(std::move(boxes)) {
    order_.resize(boxes_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    nodes_.reserve(boxes_.size() / leaf_size * 4 + 1);
    if (!order_.empty()) build(0, order_.size());
  }

  /// Calls visit(a, b) once for each pair a < b of boxes that meet; those of the
  /// same a follow each other.
  template <class Visit>
  void for_each_pair(const Visit& visit) const {
    for (std::uint32_t box = 0; box < boxes_.size(); ++box)
      for_each_after(box, [&](std::uint32_t other) { visit(box, other); });
  }

 private:
  static constexpr std::size_t leaf_size = 8;

  struct Node {
    IntegerBox box;
    std::size_t begin, end;   ///< in `order_`
    std::size_t next;         ///< the node after this one and all below it
  };

  /// Nodes stand before those below them.
  void build(std::size_t begin, std::size_t end) {
    const std::size_t at = nodes_.size();
    IntegerBox box = boxes_[order_[begin]];
    for (std::size_t i = begin; i < end; ++i) box.add(boxes_[order_[i]]);
    nodes_.push_back({box, begin, end, 0});
    if (end - begin > leaf_size) {
      const std::size_t middle = halve(box, begin, end);
      build(begin, middle);
      build(middle, end);
    }
    nodes_[at].next = nodes_.size();
  }

  std::size_t halve(const IntegerBox& box, std::size_t begin, std::size_t end) {
    const auto side = [&](std::int32_t Coord3::*axis) {
      return std::int64_t{box.high.*axis} - box.low.*axis;
    };
    auto axis = &Coord3::x;
    if (side(&Coord3::y) > side(axis)) axis = &Coord3::y;
    if (side(&Coord3::z) > side(axis)) axis = &Coord3::z;
    const auto key = [&](std::uint32_t b) {
      return std::pair(std::int64_t{boxes_[b].low.*axis} + boxes_[b].high.*axis, b);
    };
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end),
                     [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    return middle;
  }

  template <class Visit>
  void for_each_after(std::uint32_t box, const Visit& visit) const {
    for (std::size_t n = 0; n < nodes_.size();) {
      const Node& node = nodes_[n];
      if (!node.box.meets(boxes_[box])) {
        n = node.next;
        continue;
      }
      ++n;
      if (node.end - node.begin > leaf_size) continue;
      for (std::size_t i = node.begin; i < node.end; ++i)
        if (order_[i] > box && boxes_[order_[i]].meets(boxes_[box])) visit(order_[i]);
    }
  }

  std::vector<IntegerBox> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace certet
