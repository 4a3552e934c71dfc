#pragma once
/// \file
/// What hangs together in a mesh in memory: parts of one label that faces join, of which there
/// are few, and what these make up.

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "certet/mesh.hpp"
#include "certet/pieces.hpp"
#include "engine/disjoint_sets.hpp"
#include "groups.hpp"

namespace certet::core {

/// `Number` counts points, and tetrahedra.
template <class Index, class Number>
class Parts {
 public:
  Parts(std::span<const Tet<Index>> tets, std::span<const std::int32_t> labels)
      : tets_(tets), labels_(labels), sets_(tets.size()) {}

  [[nodiscard]] std::int32_t label(Number tet) const {
    return labels_.empty() ? 0 : labels_[tet];
  }

  /// Two tetrahedra share a face.  \returns whether they are of one label.
  bool join(Number a, Number b) {
    if (label(a) != label(b)) {
      across_.push_back({a, b});
      return false;
    }
    sets_.join(a, b);
    return true;
  }

  /// When all are joined: the pieces that the tetrahedra `order`, which grow, make.
  Pieces count(std::uint64_t points, std::span<const Number> order) {
    number_parts(order);
    DisjointSetsOf<Number> whole(all_.size());
    for (const auto& [a, b] : across_) whole.join(part_[a], part_[b]);
    across_ = {};
    DisjointSetsOf<Number> whole_by_points = whole, label_by_points(all_.size());
    Pieces pieces;
    pieces.whole.by_faces = count_sets(whole);
    const std::vector<bool> doubtful = find_doubtful(whole, pieces.largest);
    for_common_points(points, order, doubtful, [&](std::span<PartAt> parts) {
      for (std::size_t n = 1; n < parts.size(); ++n) {
        whole_by_points.join(parts[n - 1].part, parts[n].part);
        if (all_[parts[n - 1].part].label == all_[parts[n].part].label)
          label_by_points.join(parts[n - 1].part, parts[n].part);
      }
    });
    pieces.whole.by_vertices = count_sets(whole_by_points);
    if (!labels_.empty()) pieces.regions = regions(label_by_points);
    return pieces;
  }

 private:
  struct Part {
    std::int32_t label;
    std::uint64_t tets;
  };
  /// That a point is in a part; of one point by labels.
  struct PartAt {
    Number point;
    std::int32_t label;
    Number part;
    friend auto operator<=>(const PartAt&, const PartAt&) = default;
  };

  /// The first tetrahedron of a set is its least.
  void number_parts(std::span<const Number> order) {
    part_.resize(tets_.size());
    for (const Number tet : order) {
      const Number least = sets_.find(tet);
      if (least == tet) {
        part_[tet] = static_cast<Number>(all_.size());
        all_.push_back({label(tet), 0});
      } else {
        part_[tet] = part_[least];
      }
      ++all_[part_[tet]].tets;
    }
  }

  static std::uint64_t count_sets(DisjointSetsOf<Number>& sets) {
    std::uint64_t count = 0;
    for (std::size_t part = 0; part < sets.size(); ++part)
      if (sets.find(static_cast<Number>(part)) == part) ++count;
    return count;
  }

  /// The parts that are not the largest of their label, or not in the largest piece of the
  /// whole: of two parts that only points join, one is such.
  std::vector<bool> find_doubtful(DisjointSetsOf<Number>& whole, std::uint64_t& largest) {
    std::vector<std::uint64_t> tets(all_.size());
    std::vector<Number> order(all_.size());
    for (Number part = 0; part < all_.size(); ++part) {
      tets[whole.find(part)] += all_[part].tets;
      order[part] = part;
    }
    const auto first = std::ranges::max_element(tets);
    largest = tets.empty() ? 0 : *first;
    std::ranges::sort(order, [this](Number a, Number b) {
      return std::pair(all_[a].label, all_[b].tets) < std::pair(all_[b].label, all_[a].tets);
    });
    std::vector<bool> doubtful(all_.size());
    for (std::size_t n = 0; n < order.size(); ++n)
      doubtful[order[n]] = (n > 0 && all_[order[n - 1]].label == all_[order[n]].label) ||
                           whole.find(order[n]) != static_cast<Number>(first - tets.begin());
    return doubtful;
  }

  /// Calls visit(parts) for each point of a doubtful part, with all that it is in.
  template <class Visit>
  void for_common_points(std::uint64_t points, std::span<const Number> order,
                         const std::vector<bool>& doubtful, const Visit& visit) {
    if (std::ranges::find(doubtful, true) == doubtful.end()) return;
    std::vector<bool> marked(points);
    for (const Number tet : order)
      if (doubtful[part_[tet]])
        for (const Index point : tets_[tet]) marked[point] = true;
    std::vector<PartAt> found;
    for (const Number tet : order)
      for (const Index point : tets_[tet])
        if (marked[point])
          found.push_back({static_cast<Number>(point), label(tet), part_[tet]});
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for_runs(std::span(found), [](const PartAt& a, const PartAt& b) { return a.point == b.point; },
             visit);
  }

  std::vector<RegionPieces> regions(DisjointSetsOf<Number>& by_points) {
    std::vector<Number> order(all_.size());
    for (Number part = 0; part < all_.size(); ++part) order[part] = part;
    std::ranges::stable_sort(order, {}, [this](Number part) { return all_[part].label; });
    std::vector<RegionPieces> regions;
    for (const Number part : order) {
      if (regions.empty() || regions.back().label != all_[part].label)
        regions.push_back({all_[part].label, {}});
      ++regions.back().pieces.by_faces;
      if (by_points.find(part) == part) ++regions.back().pieces.by_vertices;
    }
    return regions;
  }

  std::span<const Tet<Index>> tets_;
  std::span<const std::int32_t> labels_;
  DisjointSetsOf<Number> sets_;  ///< of tetrahedra
  std::vector<std::array<Number, 2>> across_;  ///< tetrahedra of two labels that share a face
  std::vector<Number> part_;  ///< of each tetrahedron
  std::vector<Part> all_;
};

}  // namespace certet::core
