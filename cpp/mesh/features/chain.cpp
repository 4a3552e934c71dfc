#include "chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <tuple>

namespace certet::features {
namespace {

/// In long edges: how far from a curve a vertex may be that goes there, and one that is on it already.
constexpr double greatest_way = 1.6, on_it = 1e-3;
/// Along a curve, in long edges: no edge of a chain goes on by less than the first, but from and to
/// corners, and one that goes on by less than the second costs more.
constexpr double least_advance = 0.02, fair_advance = 0.3;
constexpr double cost_of_edge = 0.03, cost_of_sagitta = 200;
/// The sagitta of a chord that is short enough, in long edges.
constexpr double bent = 0.012;

struct Candidate {
  Number vertex;
  double at, away;  ///< along the curve, in steps, and from it, in long edges
};

/// How far the chord over a part of the curve is from its middle, in long edges.
double sagitta_of(const Curve& curve, double from, double to) {
  const Vector chord = 0.5 * (curve.place(from) + curve.place(to));
  return length(curve.place((from + to) / 2) - chord) / long_edge;
}

class Search {
 public:
  Search(const ChainSearch& search, std::uint32_t curve, Number first, Number last)
      : search_(search), curve_(search.sites.curves()[curve]), first_(first),
        last_(last), near_(search.zone.near(curve_.points())) {
    for (const Number end : {first, last})
      if (end != none) near_.push_back(end);
    std::ranges::sort(near_);
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
  }

  /// Of those alone that are beside the curve, or of all near it.
  std::vector<Number> find(bool strip) {
    collect(strip);
    if (curve_.is_loop()) return around();
    return from_end_to_end();
  }

 private:
  /// An edge from one candidate to another.
  struct Edge {
    std::uint32_t from, to;
    double cost;
  };

  void collect(bool strip);
  void connect();
  [[nodiscard]] bool may_be(Number v) const;
  [[nodiscard]] std::uint32_t index_of(Number v) const {
    const auto found = std::ranges::lower_bound(candidates_, v, {}, &Candidate::vertex);
    return found != candidates_.end() && found->vertex == v
               ? static_cast<std::uint32_t>(found - candidates_.begin())
               : none;
  }
  [[nodiscard]] bool is_beside(Number v) const;
  /// Along the curve, in long edges.
  [[nodiscard]] double advance(const Candidate& from, const Candidate& to) const;
  [[nodiscard]] std::vector<Number> around();
  void close(std::vector<Number>& loop) const;
  [[nodiscard]] std::vector<Number> from_end_to_end() const;
  /// The best way from some candidates to others, which may be the same.
  [[nodiscard]] std::vector<Number> best(const std::vector<std::uint8_t>& starts,
                                         const std::vector<std::uint8_t>& ends) const;
  [[nodiscard]] bool are_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Number u = candidates_[a].vertex, v = candidates_[b].vertex, w = candidates_[c].vertex;
    return search_.zone.are_neighbours(u, w) && u != v && v != w;
  }

  const ChainSearch& search_;
  const Curve& curve_;
  Number first_, last_;
  std::vector<Number> near_;
  std::vector<Candidate> candidates_;  ///< by growing numbers of vertices
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> first_edge_;  ///< of candidates
};

bool Search::may_be(Number v) const {
  return search_.zone.is_free(v) && search_.zone.on_surface(v) &&
         (v == first_ || v == last_ || search_.taken[v] == 0);
}

/// Whether a vertex is on a patch beside the curve and has an edge to one on the other.
bool Search::is_beside(Number v) const {
  const Site& own = search_.sites[v];
  const auto patch_of = [&](Number w) {
    const Site& site = search_.sites[w];
    return site.role == Role::face ? site.which : none;
  };
  if (own.role != Role::face) return true;
  const std::uint32_t other = own.which == curve_.left    ? curve_.right
                              : own.which == curve_.right ? curve_.left
                                                          : none;
  if (other == none) return false;
  return other == own.which || std::ranges::any_of(search_.zone.fan(v), [&](const auto& t) {
           return patch_of(t[0]) == other;
         });
}

void Search::collect(bool strip) {
  const Zone& zone = search_.zone;
  candidates_.clear();
  for (const Number v : near_) {
    if (!may_be(v)) continue;
    CurvePoint near = curve_.nearest(in_doubles(zone.place(v)));
    const bool end = v == first_ || v == last_;
    if (!end && near.away > greatest_way * long_edge) continue;
    if (!end && strip && near.away > on_it * long_edge && !is_beside(v)) continue;
    const Site& site = search_.sites[v];
    if (!end && site.role == Role::face && site.which != curve_.left && site.which != curve_.right &&
        near.away > on_it * long_edge)
      continue;
    candidates_.push_back({v, near.at, near.away / long_edge});
  }
  connect();
}

/// A curve that ends at the corner where it begins has both ends at one vertex.
double Search::advance(const Candidate& from, const Candidate& to) const {
  double by = (to.vertex == last_ ? curve_.length() : to.at) - (from.vertex == first_ ? 0 : from.at);
  if (curve_.is_loop()) by -= std::floor(by / curve_.length() + 0.5) * curve_.length();
  return by / long_edge;
}

void Search::connect() {
  edges_.clear();
  first_edge_.assign(candidates_.size() + 1, 0);
  for (std::uint32_t c = 0; c < candidates_.size(); ++c) {
    const Candidate& own = candidates_[c];
    first_edge_[c] = static_cast<std::uint32_t>(edges_.size());
    for (const auto& [next, beyond] : search_.zone.fan(own.vertex)) {
      const std::uint32_t to = index_of(next);
      if (to == none) continue;
      const double by = advance(own, candidates_[to]);
      const bool at_end = own.vertex == first_ || next == last_;
      if (by < (at_end ? 0 : least_advance)) continue;
      const double away = candidates_[to].away;
      const double begin = own.vertex == first_ ? 0 : own.at;
      const double sagitta = sagitta_of(curve_, begin, begin + by * long_edge);
      edges_.push_back({c, to,
                        away * away + cost_of_edge + 2 * std::max(0.0, fair_advance - by) +
                            cost_of_sagitta * std::max(0.0, sagitta - bent) +
                            search_.dislike[next]});
    }
  }
  first_edge_[candidates_.size()] = static_cast<std::uint32_t>(edges_.size());
}

/// Dijkstra's algorithm over edges, since which follow each other depends on both.
std::vector<Number> Search::best(const std::vector<std::uint8_t>& starts,
                                 const std::vector<std::uint8_t>& ends) const {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<double> costs(edges_.size(), -1);
  std::vector<std::uint32_t> before(edges_.size(), none);
  std::vector<std::uint8_t> done(edges_.size());
  const auto offer = [&](std::uint32_t edge, double cost, std::uint32_t from) {
    if (done[edge] != 0 || (costs[edge] >= 0 && costs[edge] <= cost)) return;
    costs[edge] = cost;
    before[edge] = from;
    open.emplace(cost, edge);
  };
  for (std::uint32_t e = 0; e < edges_.size(); ++e)
    if (starts[edges_[e].from] != 0) offer(e, edges_[e].cost, none);
  while (!open.empty()) {
    const auto [cost, edge] = open.top();
    open.pop();
    if (done[edge] != 0) continue;
    done[edge] = 1;
    const Edge& own = edges_[edge];
    if (ends[own.to] != 0) {
      std::vector<Number> way{candidates_[own.to].vertex};
      for (std::uint32_t e = edge; e != none; e = before[e])
        way.push_back(candidates_[edges_[e].from].vertex);
      std::ranges::reverse(way);
      return way;
    }
    for (std::uint32_t e = first_edge_[own.to]; e < first_edge_[own.to + 1]; ++e)
      if (!are_triangle(own.from, own.to, edges_[e].to)) offer(e, cost + edges_[e].cost, edge);
  }
  return {};
}

std::vector<Number> Search::from_end_to_end() const {
  std::vector<std::uint8_t> starts(candidates_.size()), ends(candidates_.size());
  // Where a corner has no vertex, from what is nearest to it.
  double least = curve_.length(), greatest = 0;
  for (const Candidate& one : candidates_)
    least = std::min(least, one.at), greatest = std::max(greatest, one.at);
  for (std::uint32_t c = 0; c < candidates_.size(); ++c) {
    const Candidate& own = candidates_[c];
    starts[c] = first_ == none ? own.at <= least + long_edge / 2 : own.vertex == first_;
    ends[c] = last_ == none ? own.at >= greatest - long_edge / 2 : own.vertex == last_;
  }
  return best(starts, ends);
}

/// All edges go on along the curve, so that a way that comes back has been around.  First from the
/// nearest vertex; then from where that way is the farthest from its beginning, which the beginning
/// no longer had a say in.
std::vector<Number> Search::around() {
  if (candidates_.empty()) return {};
  const auto nearest = std::ranges::min_element(candidates_, [](const auto& a, const auto& b) {
    return std::tie(a.away, a.vertex) < std::tie(b.away, b.vertex);
  });
  auto begin = static_cast<std::uint32_t>(nearest - candidates_.begin());
  std::vector<Number> way;
  for (int turn = 0; turn < 2; ++turn) {
    std::vector<std::uint8_t> ends(candidates_.size());
    ends[begin] = 1;
    std::vector<Number> found = best(ends, ends);
    if (found.empty()) return way;
    way = std::move(found);
    begin = index_of(way[way.size() / 2]);
  }
  close(way);
  return way;
}

/// Where the way goes on no three are a triangle; where it ends and begins they may be, and then the
/// one between is left out.
void Search::close(std::vector<Number>& way) const {
  constexpr std::size_t least = 5;
  while (way.size() > least && search_.zone.are_on_edge(way[way.size() - 2], way[1])) {
    way.erase(way.begin());
    way.back() = way.front();
  }
}

/// Where the vertices of a chain are to be: the nearest points of the curve, but those of its bends
/// that show, and apart from each other.
class Targets {
 public:
  Targets(const Zone& zone, const Curve& curve, const std::vector<Number>& way)
      : curve_(curve), at_(way.size()), pinned_(way.size()) {
    for (std::size_t i = 0; i < way.size(); ++i) {
      double at = curve.nearest(in_doubles(zone.place(way[i]))).at;
      // Of a loop on from the one before.
      if (curve.is_loop() && i > 0)
        at += std::round((at_[i - 1] + long_edge / 2 - at) / curve.length()) * curve.length();
      at_[i] = at;
    }
    if (curve.is_loop()) {
      at_.back() = at_.front() + curve.length();
    } else {
      if (curve.first != none) at_.front() = 0;
      if (curve.last != none) at_.back() = curve.length();
      pinned_.front() = curve.first != none;
      pinned_.back() = curve.last != none;
    }
    pin_bends();
    spread();
    even_out();
  }

  [[nodiscard]] std::vector<Coord3> places() const {
    std::vector<Coord3> places;
    for (const double at : at_) places.push_back(in_steps(curve_.place(at)));
    if (curve_.is_loop()) places.back() = places.front();
    return places;
  }
  [[nodiscard]] const std::vector<std::uint8_t>& pinned() const { return pinned_; }

 private:
  struct Bend {
    double turn, at;
  };

  void pin_bends();
  void pin(double at);
  void spread();
  void even_out();

  const Curve& curve_;
  std::vector<double> at_;
  std::vector<std::uint8_t> pinned_;
};

void Targets::pin_bends() {
  constexpr double least_turn = 4;  // degrees
  std::vector<Bend> bends;
  const auto points = curve_.points();
  const auto lengths = curve_.lengths();
  const std::size_t segments = points.size() - 1;
  for (std::size_t i = curve_.is_loop() ? 0 : 1; i < segments; ++i) {
    const Vector in = points[i] - points[i == 0 ? segments - 1 : i - 1], out = points[i + 1] - points[i];
    const double turn =
        std::atan2(length(cross(in, out)), dot(in, out)) *
        (180 / std::numbers::pi);
    if (turn >= least_turn) bends.push_back({turn, lengths[i]});
  }
  std::ranges::sort(bends, [](const Bend& a, const Bend& b) {
    return std::tie(b.turn, a.at) < std::tie(a.turn, b.at);
  });
  for (const Bend& bend : bends) pin(bend.at);
}

/// The nearest vertex that is not pinned yet, if that leaves the pinned ones in their order.
void Targets::pin(double at) {
  constexpr double greatest_slide = 0.7 * long_edge;
  if (curve_.is_loop())
    at += std::ceil((at_.front() - at) / curve_.length()) * curve_.length();
  std::size_t nearest = at_.size();
  double best = greatest_slide;
  const std::size_t ends = curve_.is_loop() ? at_.size() - 1 : at_.size();
  for (std::size_t i = 0; i < ends; ++i) {
    // The first of a loop is the last, too.
    double way = std::fabs(at_[i] - at);
    if (curve_.is_loop() && i == 0) way = std::min(way, std::fabs(at_.back() - at));
    if (pinned_[i] == 0 && way < best) nearest = i, best = way;
  }
  if (nearest == at_.size()) return;
  if (curve_.is_loop() && nearest == 0 && std::fabs(at_.back() - at) < std::fabs(at_[0] - at))
    at -= curve_.length();
  for (std::size_t i = 0; i < at_.size(); ++i)
    if (pinned_[i] != 0 && (i < nearest ? at_[i] >= at : i > nearest && at_[i] <= at)) return;
  at_[nearest] = at;
  pinned_[nearest] = 1;
  if (curve_.is_loop() && nearest == 0) {
    at_.back() = at + curve_.length();
    pinned_.back() = 1;
  }
}

/// Between two that are pinned no two neighbours are nearer to each other than a part of their mean
/// distance.
void Targets::spread() {
  constexpr double least_share = 0.4;
  for (std::size_t a = 0; a + 1 < at_.size();) {
    std::size_t b = a + 1;
    while (b + 1 < at_.size() && pinned_[b] == 0) ++b;
    const double gap = least_share * (at_[b] - at_[a]) / static_cast<double>(b - a);
    for (std::size_t i = a + 1; i < b; ++i) at_[i] = std::max(at_[i], at_[i - 1] + gap);
    for (std::size_t i = b; i-- > a + 1;) at_[i] = std::min(at_[i], at_[i + 1] - gap);
    a = b;
  }
}

/// Where the curve is bent, those that are not pinned move towards the middles between their
/// neighbours, so that no chord is long.
void Targets::even_out() {
  constexpr int sweeps = 30;
  constexpr double greatest_slide = 0.3 * long_edge;
  const std::vector<double> before = at_;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (std::size_t i = 1; i + 1 < at_.size(); ++i) {
      if (pinned_[i] != 0 || sagitta_of(curve_, at_[i - 1], at_[i + 1]) < bent) continue;
      at_[i] = std::clamp((at_[i - 1] + at_[i + 1]) / 2, before[i] - greatest_slide,
                          before[i] + greatest_slide);
    }
}

}  // namespace

Chain find_chain(const ChainSearch& search, std::uint32_t curve, Number first, Number last) {
  Search one(search, curve, first, last);
  Chain chain{one.find(true), {}, {}};
  if (chain.empty()) chain.vertices = one.find(false);
  if (chain.empty()) return chain;
  const Targets targets(search.zone, search.sites.curves()[curve], chain.vertices);
  chain.targets = targets.places();
  chain.pinned = targets.pinned();
  return chain;
}

}  // namespace certet::features
