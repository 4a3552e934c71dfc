#include "rim_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "vectors.hpp"

namespace certet {
namespace {

constexpr std::uint32_t leaf_edges = 4;

Point3 real(Coord3 c) {
  return {static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z)};
}

/// One rim, before it is in the tree.
struct Rim {
  std::uint32_t first, last;
  std::array<std::int64_t, 3> middle;  ///< twice, of its box
};

class RimTreeBuilder {
 public:
  explicit RimTreeBuilder(RimTree& tree) : tree_(tree) {}

  void add(std::span<Rim> rims) {
    if (rims.size() == 1) return add_piece(rims[0].first, rims[0].last);
    const std::uint32_t node = begin(rims[0].first, rims[0].first);
    split(rims);
    add_below(node, [&] { add(rims.first(rims.size() / 2)); });
    add_below(node, [&] { add(rims.subspan(rims.size() / 2)); });
    finish(node);
  }

 private:
  /// From one point of the chain to another.
  void add_piece(std::uint32_t first, std::uint32_t last) {
    const std::uint32_t node = begin(first, last);
    if (last - first <= leaf_edges) {
      for (std::uint32_t p = first; p < last; ++p) add_edge(node, p);
    } else {
      const std::uint32_t middle = first + (last - first) / 2;
      add_below(node, [&] { add_piece(first, middle); });
      add_below(node, [&] { add_piece(middle, last); });
      add_area(node, first, middle, last);
    }
    finish(node);
  }

  [[nodiscard]] double length(std::uint32_t first, std::uint32_t last) const {
    const Point3 edge = difference(real(tree_.chain[last]), real(tree_.chain[first]));
    return std::sqrt(dot(edge, edge));
  }

  std::uint32_t begin(std::uint32_t first, std::uint32_t last) {
    tree_.nodes.push_back({first, last});
    tree_.nodes.back().box = {tree_.chain[first], tree_.chain[first]};
    return static_cast<std::uint32_t>(tree_.nodes.size()) - 1;
  }

  void add_edge(std::uint32_t node, std::uint32_t p) {
    RimNode& to = tree_.nodes[node];
    to.box.add({tree_.chain[p + 1], tree_.chain[p + 1]});
    to.length += length(p, p + 1);
    add_area(node, to.first, p, p + 1);
  }

  /// The triangle between three points of the chain.
  void add_area(std::uint32_t node, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    AreaMoments& area = tree_.nodes[node].area;
    area = area.with({real(tree_.chain[a]), real(tree_.chain[b]), real(tree_.chain[c])});
  }

  template <class Add>
  void add_below(std::uint32_t node, const Add& add) {
    const auto below = static_cast<std::uint32_t>(tree_.nodes.size());
    add();
    RimNode& to = tree_.nodes[node];
    const RimNode& from = tree_.nodes[below];
    to.box.add(from.box);
    to.length += from.length;
    to.area = to.area.with(from.area);
  }

  void finish(std::uint32_t node) {
    RimNode& done = tree_.nodes[node];
    done.next = static_cast<std::uint32_t>(tree_.nodes.size());
    done.chord = length(done.first, done.last);
    const Point3 low = real(done.box.low), high = real(done.box.high);
    done.centre = done.area.area() > 0 ? done.area.centre() : between(low, high, 0.5);
    Point3 reach;
    for (std::size_t i = 0; i < 3; ++i)
      reach[i] = std::max(high[i] - done.centre[i], done.centre[i] - low[i]);
    done.radius = std::sqrt(dot(reach, reach));
  }

  /// Halves them along the axis on which their middles are farthest apart.
  static void split(std::span<Rim> rims) {
    std::array<std::int64_t, 3> low = rims[0].middle, high = low;
    for (const Rim& rim : rims)
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], rim.middle[i]);
        high[i] = std::max(high[i], rim.middle[i]);
      }
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
    std::nth_element(rims.begin(), rims.begin() + static_cast<std::ptrdiff_t>(rims.size() / 2),
                     rims.end(), [&](const Rim& a, const Rim& b) {
                       return std::pair(a.middle[axis], a.first) < std::pair(b.middle[axis], b.first);
                     });
  }

  RimTree& tree_;
};

Rim rim_of(const RimLoop& loop, std::uint32_t first) {
  IntegerBox box{loop[0], loop[0]};
  for (const Coord3 p : loop) box.add({p, p});
  const auto twice = [](std::int32_t a, std::int32_t b) { return std::int64_t{a} + b; };
  return {first, first + static_cast<std::uint32_t>(loop.size()) - 1,
          {twice(box.low.x, box.high.x), twice(box.low.y, box.high.y),
           twice(box.low.z, box.high.z)}};
}

}  // namespace

RimTree::RimTree(const std::vector<RimLoop>& loops) {
  std::vector<Rim> rims;
  for (const RimLoop& loop : loops) {
    rims.push_back(rim_of(loop, static_cast<std::uint32_t>(chain.size())));
    chain.insert(chain.end(), loop.begin(), loop.end());
  }
  if (!rims.empty()) RimTreeBuilder(*this).add(rims);
}

}  // namespace certet
