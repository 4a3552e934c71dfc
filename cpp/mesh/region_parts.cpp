#include "region_parts.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

namespace certet::core {
namespace {

constexpr std::uint32_t no_part = 0xffffffff;

/// Which parts are at the points that a layer's tetrahedra use.
class PartsAtPoints {
 public:
  PartsAtPoints(const std::vector<std::int32_t>& labels, std::uint64_t first_point,
                std::size_t points, std::vector<PartPair>& touching)
      : labels_(labels), first_point_(first_point), touching_(touching), joined_(labels.size()),
        first_(points, no_part), last_(points, no_part) {}

  void add(std::uint64_t point, std::uint32_t part) {
    const std::size_t at = point - first_point_;
    std::uint32_t& first = first_[at];
    if (first == no_part) first = part;
    if (first == part) return;
    if (labels_[first] == labels_[part])
      touch(first, part);
    else if (std::exchange(last_[at], part) != part)
      more_.push_back({point, part});
  }

  /// By points, of each label one.
  std::vector<PartPoint> all() {
    const auto key = [this](const PartPoint& at) { return std::tuple(at.point, labels_[at.part]); };
    std::ranges::stable_sort(more_, {}, key);
    std::vector<PartPoint> others;
    for (const PartPoint& at : more_) {
      if (!others.empty() && key(others.back()) == key(at))
        touch(others.back().part, at.part);
      else
        others.push_back(at);
    }
    std::vector<PartPoint> firsts;
    for (std::size_t n = 0; n < first_.size(); ++n)
      if (first_[n] != no_part) firsts.push_back({first_point_ + n, first_[n]});
    std::vector<PartPoint> merged;
    merged.reserve(firsts.size() + others.size());
    std::ranges::merge(firsts, others, std::back_inserter(merged), {}, &PartPoint::point,
                       &PartPoint::point);
    return merged;
  }

 private:
  void touch(std::uint32_t a, std::uint32_t b) {
    if (joined_.join(a, b)) touching_.push_back({a, b});
  }

  const std::vector<std::int32_t>& labels_;
  std::uint64_t first_point_;
  std::vector<PartPair>& touching_;
  DisjointSets joined_;
  std::vector<std::uint32_t> first_;  ///< of each point
  std::vector<std::uint32_t> last_;   ///< of each, the part that was last put into `more_`
  std::vector<PartPoint> more_;       ///< of other labels than the first
};

void number_parts(DisjointSets& sets, std::span<const std::int32_t> labels, LayerParts& parts) {
  parts.of_tets.resize(labels.size());
  for (std::uint32_t t = 0; t < labels.size(); ++t) {
    const std::uint32_t least = sets.find(t);
    if (least == t) {
      parts.of_tets[t] = static_cast<std::uint32_t>(parts.labels.size());
      parts.labels.push_back(labels[t]);
    } else {
      parts.of_tets[t] = parts.of_tets[least];
    }
  }
}

/// Calls visit(a, b) for the parts of two layers that are at the same point.
template <class Visit>
void for_common_points(std::span<const PartPoint> a, std::span<const PartPoint> b,
                       const Visit& visit) {
  auto other = b.begin();
  for (const PartPoint& own : a) {
    while (other != b.end() && other->point < own.point) ++other;
    for (auto at = other; at != b.end() && at->point == own.point; ++at)
      visit(own.part, at->part);
  }
}

}  // namespace

template <class Index>
LayerParts find_layer_parts(const Stuffing& stuffing, std::int32_t layer,
                            std::span<const Tet<Index>> tets,
                            std::span<const std::int32_t> labels) {
  LayerParts parts;
  DisjointSets sets(tets.size());
  stuffing.visit_faces_within(layer, [&](std::span<const TetPair> pairs) {
    for (const auto& [a, b] : pairs)
      if (labels[a] == labels[b]) sets.join(a, b);
  });
  number_parts(sets, labels, parts);
  const std::uint64_t first = stuffing.first_point(layer);
  const std::uint64_t behind = stuffing.first_point(layer + 1);
  const std::uint64_t end = stuffing.first_point(std::min(layer + 2, stuffing.layers()));
  PartsAtPoints points(parts.labels, first, end - first, parts.touching);
  for (std::size_t t = 0; t < tets.size(); ++t)
    for (const Index point : tets[t]) points.add(point, parts.of_tets[t]);
  parts.at_own = points.all();
  const auto next = std::ranges::lower_bound(parts.at_own, behind, {}, &PartPoint::point);
  parts.at_next.assign(next, parts.at_own.end());
  parts.at_own.erase(next, parts.at_own.end());
  return parts;
}

template LayerParts find_layer_parts(const Stuffing&, std::int32_t,
                                     std::span<const Tet<std::uint32_t>>,
                                     std::span<const std::int32_t>);
template LayerParts find_layer_parts(const Stuffing&, std::int32_t,
                                     std::span<const Tet<std::uint64_t>>,
                                     std::span<const std::int32_t>);

JoinedParts find_joined_parts(const Stuffing& stuffing, std::int32_t layer,
                              const LayerParts& own, const LayerParts& next) {
  JoinedParts joined;
  const auto before = static_cast<std::uint32_t>(own.labels.size());
  DisjointSets by_faces(before + next.labels.size());
  DisjointSets by_points = by_faces;
  stuffing.visit_faces_between(layer, [&](std::span<const TetPair> pairs) {
    for (const auto& [a, b] : pairs) {
      const std::uint32_t p = own.of_tets[a];
      const std::uint32_t q = next.of_tets[b];
      if (own.labels[p] == next.labels[q] && by_faces.join(p, before + q))
        joined.by_faces.push_back({p, q});
    }
  });
  for_common_points(own.at_next, next.at_own, [&](std::uint32_t p, std::uint32_t q) {
    if (own.labels[p] == next.labels[q] && by_points.join(p, before + q))
      joined.by_points.push_back({p, q});
  });
  return joined;
}

void RegionParts::add(const LayerParts& layer, const JoinedParts& joined) {
  const auto first = static_cast<std::uint32_t>(labels_.size());
  labels_.insert(labels_.end(), layer.labels.begin(), layer.labels.end());
  by_faces_.grow(labels_.size());
  by_points_.grow(labels_.size());
  for (const auto& [a, b] : layer.touching) by_points_.join(first + a, first + b);
  for (const auto& [a, b] : joined.by_faces) by_faces_.join(first_of_last_ + a, first + b);
  for (const auto& [a, b] : joined.by_points) by_points_.join(first_of_last_ + a, first + b);
  first_of_last_ = first;
}

std::vector<RegionPieces> RegionParts::pieces() {
  std::map<std::int32_t, PieceCount> counts;
  for (std::uint32_t part = 0; part < labels_.size(); ++part) {
    PieceCount& count = counts[labels_[part]];
    if (by_faces_.find(part) == part) ++count.by_faces;
    if (by_points_.find(part) == part) ++count.by_vertices;
  }
  std::vector<RegionPieces> pieces;
  for (const auto& [label, count] : counts) pieces.push_back({label, count});
  return pieces;
}

}  // namespace certet::core
