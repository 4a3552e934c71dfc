#include "curve.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace certet::features {
namespace {

distance::TriangleTree tree_of(const std::vector<Vector>& points) {
  std::vector<distance::Triangle> segments;
  for (std::uint32_t i = 0; i + 1 < points.size(); ++i) segments.push_back({i, i + 1, i + 1});
  return {points, std::move(segments)};
}

/// Follows sharp edges.
class Walker {
 public:
  explicit Walker(const Features& features) : features_(features), used_(features.edges.size()) {
    for (std::uint32_t e = 0; e < features.edges.size(); ++e) {
      at_[features.edges[e].from].push_back(e);
      at_[features.edges[e].to].push_back(e);
    }
  }

  std::vector<Curve> all() {
    for (std::uint32_t c = 0; c < features_.corners.size(); ++c)
      for (const std::uint32_t e : at_[features_.corners[c]])
        if (!used_[e]) walk(features_.corners[c], e, c);
    for (std::uint32_t e = 0; e < used_.size(); ++e)
      if (!used_[e]) walk(features_.edges[e].from, e, none);
    return std::move(curves_);
  }

 private:
  void walk(Coord3 from, std::uint32_t edge, std::uint32_t corner) {
    std::vector<Vector> points{in_doubles(from)};
    const bool forward = features_.edges[edge].from == from;
    std::uint32_t left = features_.edges[edge].left, right = features_.edges[edge].right;
    if (!forward) std::swap(left, right);
    std::uint32_t last = none;
    while (edge != none) {
      used_[edge] = true;
      const FeatureEdge& own = features_.edges[edge];
      from = own.from == from ? own.to : own.from;
      points.push_back(in_doubles(from));
      last = corner_at(from);
      edge = last == none ? next_at(from) : none;
    }
    curves_.emplace_back(std::move(points), left, right, corner, last);
  }

  [[nodiscard]] std::uint32_t corner_at(Coord3 point) const {
    const auto found = std::ranges::lower_bound(features_.corners, point);
    return found != features_.corners.end() && *found == point
               ? static_cast<std::uint32_t>(found - features_.corners.begin())
               : none;
  }
  [[nodiscard]] std::uint32_t next_at(Coord3 point) {
    for (const std::uint32_t e : at_[point])
      if (!used_[e]) return e;
    return none;
  }

  const Features& features_;
  std::vector<bool> used_;
  std::map<Coord3, std::vector<std::uint32_t>> at_;
  std::vector<Curve> curves_;
};

}  // namespace

Curve::Curve(std::vector<Vector> points, std::uint32_t left_patch, std::uint32_t right_patch,
             std::uint32_t first_corner, std::uint32_t last_corner)
    : left(left_patch), right(right_patch), first(first_corner), last(last_corner),
      points_(std::move(points)), at_{0}, tree_(tree_of(points_)) {
  for (std::size_t i = 1; i < points_.size(); ++i)
    at_.push_back(at_.back() + optimising::length(points_[i] - points_[i - 1]));
}

CurvePoint Curve::nearest(const Vector& point) const {
  const distance::Nearest found = tree_.nearest(point);
  const Vector on = distance::nearest_on(tree_.corners(found.triangle), point);
  return {on, at_[found.triangle] + optimising::length(on - points_[found.triangle]),
          std::sqrt(found.square)};
}

std::size_t Curve::segment(double at) const {
  const auto after = std::ranges::upper_bound(at_, at) - at_.begin();
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - 1, 0, std::ssize(at_) - 2));
}

Vector Curve::place(double at) const {
  if (is_loop()) at -= std::floor(at / length()) * length();
  const std::size_t i = segment(at);
  const double size = at_[i + 1] - at_[i];
  const double share = size > 0 ? std::clamp((at - at_[i]) / size, 0.0, 1.0) : 0;
  return share == 1 ? points_[i + 1] : points_[i] + share * (points_[i + 1] - points_[i]);
}

Vector Curve::direction(double at) const {
  const std::size_t i = segment(at);
  const Vector by = points_[i + 1] - points_[i];
  const double size = optimising::length(by);
  return size > 0 ? (1 / size) * by : Vector{0, 0, 0};
}

std::vector<Curve> curves_of(const Features& features) { return Walker(features).all(); }

}  // namespace certet::features
