#include <algorithm>
#include <map>
#include <memory>
#include <new>
#include <set>
#include <tuple>
#include <utility>

#include "certet/error.hpp"
#include "certet/features.hpp"
#include "chain.hpp"
#include "kept_length.hpp"
#include "mover.hpp"
#include "traced_patches.hpp"

namespace certet {
namespace features {
namespace {

/// What is to be kept, and the surface between.
struct Kept {
  const Features& features;
  const Patches& patches;
  bool holds_border;  ///< vertices where the shape is cut off stay
};

/// A vertex that is to go somewhere, and what it is on from then on.
struct Pending {
  Number vertex;
  Coord3 target;
  Site then;
};

/// Limits of the first rounds, so that vertices which can come by with better angles do.
constexpr AngleLimits first_limits{{138, 10}, {46, 10}};  // about 15 and 155 degrees
constexpr int first_rounds = 6, most_rounds = 40;
constexpr double aim = 25, last_aim = 20;  ///< degrees
constexpr int tries_of_corners = 3, tries_of_chains = 6, tries_of_all = 8, tries_in_vain = 3;
constexpr double corner_reach = 1.6;  ///< long edges

class Keeper {
 public:
  /// `dislike`: what earlier ones have learnt, of vertices; or empty.
  Keeper(const Mesh& mesh, const Kept& kept, const std::vector<double>& dislike, Context& context)
      : features_(kept.features), context_(context), curves_(curves_of(features_)),
        zone_(mesh, features_.edges, kept.holds_border), sites_(zone_, kept.patches, curves_),
        limits_(limits_of(mesh.method)), mover_(zone_, sites_, limits_), taken_(zone_.size()),
        is_corner_(zone_.size()), dislike_(dislike), lessons_(dislike),
        corners_(features_.corners.size(), none), chains_(curves_.size()),
        home_(zone_.size(), none) {
    dislike_.resize(zone_.size());
    lessons_.resize(zone_.size());
    for (Number v = 0; v < zone_.size(); ++v) home_[v] = sites_[v].which;
  }

  FeatureFigures run() {
    place_corners();
    for (int turn = 0; turn < tries_of_chains && find_chains(); ++turn) push_chains();
    settle();
    even_out();
    return figures();
  }
  /// What another is to avoid: vertices that were stopped, and corners of chains that have them.
  [[nodiscard]] std::vector<double> lessons() const;
  void store(Mesh& mesh) const;

 private:
  /// \returns those that did not arrive.
  std::vector<Pending> push(std::vector<Pending> pending);
  bool make_room(const std::vector<Pending>& pending);
  bool slide(Pending& one);

  void place_corners();
  /// Another vertex is to go to a corner.
  void give_up(Number v) {
    taken_[v] = is_corner_[v] = 0;
    dislike_[v] += 1;
  }
  Number corner_vertex(std::uint32_t corner, const std::set<std::uint32_t>& beside) const;
  [[nodiscard]] std::vector<Pending> pending_corners() const;

  std::vector<std::uint32_t> lost_first();
  bool find_chains();
  void push_chains();
  void release(Chain& chain);
  [[nodiscard]] bool is_done(const Chain& chain) const;
  [[nodiscard]] std::vector<Pending> pending_chains() const;
  void take_sides(std::vector<Pending>& pending);

  void settle();
  void even_out();
  FeatureFigures figures();

  const Features& features_;
  Context& context_;
  std::vector<Curve> curves_;
  Zone zone_;
  Sites sites_;
  AngleLimits limits_;
  Mover mover_;
  std::vector<std::uint8_t> taken_, is_corner_;
  std::vector<double> dislike_, lessons_;
  std::vector<Number> corners_;  ///< the vertices of corners
  std::vector<Chain> chains_;
  bool is_new_ = true;       ///< no chain was looked for
  std::vector<std::uint32_t> home_;  ///< patches of vertices, before they went to curves
};

std::vector<Pending> Keeper::push(std::vector<Pending> pending) {
  for (int round = 0; round < most_rounds && !pending.empty(); ++round) {
    stop_if_cancelled(context_);
    const bool first = round < first_rounds;
    mover_.keep(first ? first_limits : limits_);
    bool any = false;
    for (Pending& one : pending)
      any = mover_.push(one.vertex, one.target) || (!first && slide(one)) || any;
    std::erase_if(pending, [&](const Pending& one) {
      if (zone_.place(one.vertex) != one.target) return false;
      sites_.set(one.vertex, one.then);
      return true;
    });
    any = make_room(pending) || any;
    if (!any && !first) break;
  }
  return pending;
}

/// One that is stopped on its way to a curve may come to that elsewhere.
bool Keeper::slide(Pending& one) {
  if (one.then.role != Role::curve) return false;
  const Curve& curve = curves_[one.then.which];
  const double at = curve.nearest(in_doubles(zone_.place(one.vertex))).at;
  for (const double by : {0.0, 0.1, -0.1, 0.2, -0.2, 0.35, -0.35, 0.5, -0.5}) {
    const double there = at + by * long_edge;
    if (!curve.is_loop() && (there <= 0 || there >= curve.length())) continue;
    const Coord3 place = in_steps(curve.place(there));
    if (!mover_.put_at(one.vertex, place)) continue;
    one.target = place;
    return true;
  }
  return false;
}

/// The neighbours of those that are blocked move for better angles.
bool Keeper::make_room(const std::vector<Pending>& pending) {
  std::set<Number> still, around;
  for (const Pending& one : pending) still.insert(one.vertex);
  for (const Pending& one : pending)
    for (const Number v : zone_.neighbours(one.vertex))
      if (!still.contains(v)) around.insert(v);
  bool any = false;
  for (const Number v : around) any = mover_.relax(v, squared_cosine(aim)) || any;
  return any;
}

std::vector<Pending> Keeper::pending_corners() const {
  std::vector<Pending> pending;
  for (std::size_t c = 0; c < corners_.size(); ++c)
    if (corners_[c] != none && zone_.place(corners_[c]) != features_.corners[c])
      pending.push_back({corners_[c], features_.corners[c], {Role::fixed, none}});
  return pending;
}

/// The nearest, but rather one that has vertices of all patches beside the corner around.
Number Keeper::corner_vertex(std::uint32_t corner, const std::set<std::uint32_t>& beside) const {
  constexpr double cost_of_patch = 0.35;
  const Coord3 place = features_.corners[corner];
  Number best = none;
  double least = 1e9;
  const Vector line = in_doubles(place);
  for (const Number v : zone_.near({&line, 1})) {
    if (taken_[v] != 0) continue;
    const double away = length(between(zone_.place(v), place)) / long_edge;
    if (away > corner_reach) continue;
    std::set<std::uint32_t> seen{home_[v]};
    for (const auto& [next, last] : zone_.fan(v)) seen.insert(home_[next]);
    double cost = away + dislike_[v];
    for (const std::uint32_t patch : beside) cost += seen.contains(patch) ? 0 : cost_of_patch;
    if (cost < least) best = v, least = cost;
  }
  return best;
}

void Keeper::place_corners() {
  std::vector<std::set<std::uint32_t>> beside(corners_.size());
  for (const Curve& curve : curves_)
    for (const std::uint32_t end : {curve.first, curve.last})
      if (end != none) beside[end].insert({curve.left, curve.right});
  for (int turn = 0; turn < tries_of_corners; ++turn) {
    for (std::uint32_t c = 0; c < corners_.size(); ++c) {
      if (corners_[c] != none && zone_.place(corners_[c]) == features_.corners[c]) continue;
      if (corners_[c] != none) give_up(corners_[c]);
      corners_[c] = corner_vertex(c, beside[c]);
      if (corners_[c] != none) taken_[corners_[c]] = is_corner_[corners_[c]] = 1;
    }
    if (push(pending_corners()).empty()) break;
  }
}

bool Keeper::is_done(const Chain& chain) const {
  if (chain.empty()) return false;
  for (std::size_t i = 0; i < chain.vertices.size(); ++i)
    if (const Role role = sites_[chain.vertices[i]].role; role != Role::curve && role != Role::fixed)
      return false;
  return true;
}

/// Those that did not arrive are not wanted again.
void Keeper::release(Chain& chain) {
  for (const Number v : chain.vertices) {
    if (is_corner_[v] != 0) continue;
    taken_[v] = 0;
    if (sites_[v].role == Role::face) dislike_[v] += 1;
    sites_.set(v, {Role::face, home_[v]});
  }
  chain = {};
}

/// Curves for which no chain was found, which begin again before others; those that end where they
/// do make room.
std::vector<std::uint32_t> Keeper::lost_first() {
  std::vector<std::uint32_t> order;
  std::set<std::uint32_t> ends;
  for (std::uint32_t c = 0; c < curves_.size(); ++c) {
    if (!is_new_ && chains_[c].empty()) {
      order.push_back(c);
      ends.insert({curves_[c].first, curves_[c].last});
    }
  }
  ends.erase(none);
  for (std::uint32_t c = 0; c < curves_.size(); ++c) {
    if (!is_new_ && chains_[c].empty()) continue;
    order.push_back(c);
    if (ends.contains(curves_[c].first) || ends.contains(curves_[c].last)) release(chains_[c]);
  }
  is_new_ = false;
  return order;
}

/// \returns whether there are any that are new.
bool Keeper::find_chains() {
  const std::vector<std::uint32_t> order = lost_first();
  bool any = false;
  for (const std::uint32_t c : order)
    if (!is_done(chains_[c])) release(chains_[c]), any = true;
  for (const std::uint32_t c : order) {
    if (!chains_[c].empty()) continue;
    const Curve& curve = curves_[c];
    const auto vertex_at = [&](std::uint32_t end) { return end == none ? none : corners_[end]; };
    chains_[c] = find_chain({zone_, sites_, taken_, dislike_}, c, vertex_at(curve.first),
                            vertex_at(curve.last));
    for (const Number v : chains_[c].vertices) taken_[v] = 1;
  }
  return any;
}

std::vector<Pending> Keeper::pending_chains() const {
  std::vector<Pending> pending = pending_corners();
  for (std::uint32_t c = 0; c < chains_.size(); ++c) {
    const Chain& chain = chains_[c];
    for (std::size_t i = 0; i < chain.vertices.size(); ++i) {
      const Number v = chain.vertices[i];
      const bool again = i + 1 == chain.vertices.size() && curves_[c].is_loop();
      if (again || sites_[v].role != Role::face || is_corner_[v] != 0) continue;
      const Site then = chain.pinned[i] != 0 ? Site{Role::fixed, none} : Site{Role::curve, c};
      pending.push_back({v, chain.targets[i], then});
    }
  }
  return pending;
}

void Keeper::push_chains() {
  std::vector<Pending> pending = pending_chains();
  // Some may be there already.
  std::erase_if(pending, [&](const Pending& one) {
    if (zone_.place(one.vertex) != one.target) return false;
    sites_.set(one.vertex, one.then);
    return true;
  });
  take_sides(pending);
  push(std::move(pending));
}

/// Vertices beside chains belong to the patch on their side of these.
void Keeper::take_sides(std::vector<Pending>& pending) {
  std::map<std::pair<Number, Number>, std::uint32_t> left_of;
  for (std::size_t c = 0; c < chains_.size(); ++c)
    for (std::size_t i = 0; i + 1 < chains_[c].vertices.size(); ++i) {
      const Number v = chains_[c].vertices[i], w = chains_[c].vertices[i + 1];
      left_of[{v, w}] = curves_[c].left;
      left_of[{w, v}] = curves_[c].right;
    }
  std::map<Number, std::set<std::uint32_t>> wanted;
  for (auto at = left_of.begin(); at != left_of.end();) {
    const Number v = at->first.first;
    const auto end = left_of.lower_bound({v + 1, 0});
    const auto fan = zone_.fan(v);
    const auto start = std::ranges::find(fan, at->first.second,
                                         [](const auto& t) { return t[0]; }) - fan.begin();
    std::uint32_t patch = none;
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const Number w = fan[(static_cast<std::size_t>(start) + i) % fan.size()][0];
      if (const auto chain = left_of.find({v, w}); chain != left_of.end()) patch = chain->second;
      else wanted[w].insert(patch);
    }
    at = end;
  }
  for (const auto& [w, patches] : wanted) {
    if (taken_[w] != 0 || sites_[w].role != Role::face || patches.size() != 1 ||
        patches.contains(sites_[w].which))
      continue;
    const Site site{Role::face, *patches.begin()};
    Vector middle{0, 0, 0};
    for (const auto& [next, last] : zone_.fan(w)) middle = middle + in_doubles(zone_.place(next));
    middle = (1.0 / static_cast<double>(zone_.fan(w).size())) * middle;
    home_[w] = site.which;
    sites_.set(w, site);
    pending.push_back({w, sites_.onto(site, middle), site});
  }
}

/// Vertices of faces that are beside these go onto them.
void Keeper::settle() {
  std::vector<Pending> pending;
  for (Number v = 0; v < zone_.size(); ++v) {
    if (!zone_.is_free(v) || sites_[v].role != Role::face) continue;
    const Coord3 on = sites_.onto(sites_[v], in_doubles(zone_.place(v)));
    if (length(between(zone_.place(v), on)) > 2) pending.push_back({v, on, sites_[v]});
  }
  push(std::move(pending));
}

void Keeper::even_out() {
  constexpr int sweeps = 4;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    stop_if_cancelled(context_);
    bool any = false;
    for (Number v = 0; v < zone_.size(); ++v)
      any = mover_.relax(v, squared_cosine(last_aim)) || any;
    if (!any) break;
  }
}

FeatureFigures Keeper::figures() {
  FeatureFigures found = measure_features(zone_, curves_, chains_);
  found.corners = corners_.size();
  for (std::size_t c = 0; c < corners_.size(); ++c)
    found.kept_corners += corners_[c] != none && zone_.place(corners_[c]) == features_.corners[c];
  for (Number v = 0; v < zone_.size(); ++v) {
    if (zone_.place(v) == zone_.origin(v)) continue;
    ++found.moved;
    found.greatest_move = std::max(
        found.greatest_move, length(between(zone_.origin(v), zone_.place(v))) / long_edge);
  }
  return found;
}

std::vector<double> Keeper::lessons() const {
  constexpr double cost_of_corner = 0.4;
  std::vector<double> lessons = lessons_;
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    if (is_done(chains_[c])) continue;
    for (const std::uint32_t end : {curves_[c].first, curves_[c].last})
      if (end != none && corners_[end] != none) lessons[corners_[end]] += cost_of_corner;
    for (const Number v : chains_[c].vertices)
      if (sites_[v].role == Role::face) lessons[v] += 1;
  }
  return lessons;
}

void Keeper::store(Mesh& mesh) const {
  for (Number v = 0; v < zone_.size(); ++v) mesh.points[zone_.in_mesh(v)] = zone_.place(v);
}

/// Whether more is kept.
bool is_better(const FeatureFigures& one, const FeatureFigures& other) {
  return std::tie(one.kept_corners, one.followed_length) >
         std::tie(other.kept_corners, other.followed_length);
}

/// Whether the size is too large for the shape, so that no try helps.
bool is_hopeless(const FeatureFigures& figures) {
  return figures.kept_corners < figures.corners && 2 * figures.followed_length < figures.length;
}

/// Begins anew where something is lost, as long as that helps, and has the best.
FeatureFigures keep(Mesh& mesh, const Kept& kept, Context& context) {
  std::unique_ptr<Keeper> best;
  FeatureFigures figures;
  std::vector<double> dislike;
  int in_vain = 0;
  for (int turn = 0; turn < tries_of_all && in_vain < tries_in_vain; ++turn) {
    auto keeper = std::make_unique<Keeper>(mesh, kept, dislike, context);
    const FeatureFigures found = keeper->run();
    dislike = keeper->lessons();
    if (!best || is_better(found, figures))
      best = std::move(keeper), figures = found, in_vain = 0;
    else
      ++in_vain;
    if (figures.all_followed() || is_hopeless(figures)) break;
  }
  best->store(mesh);
  return figures;
}

void refuse_steps(const Mesh& mesh) {
  if (facts(mesh.method).cuts == Cuts::midpoint)
    throw Error(ErrorCode::bad_option,
                "vertices cannot move onto sharp edges from a surface that passes the middles of edges");
}

template <class Work>
auto within_memory(const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "out of memory to keep sharp edges");
  }
}

}  // namespace
}  // namespace features

FeatureFigures keep_features(Mesh& mesh, const Features& features, Context& context) {
  features::refuse_steps(mesh);
  if (features.none() || mesh.tet_count() == 0) return {};
  return features::within_memory([&] {
    return features::keep(mesh, {features, features::TrianglePatches(features), true}, context);
  });
}

FeatureFigures keep_features(Mesh& mesh, const PlacedDomain& domain, double angle,
                             Context& context) {
  features::refuse_steps(mesh);
  if (mesh.tet_count() == 0) return {};
  if (const Features known = features_of(domain, angle); !known.triangles.empty())
    return keep_features(mesh, known, context);
  return features::within_memory([&]() -> FeatureFigures {
    const features::Traced traced = features::trace(mesh, domain, angle, context);
    if (traced.features.none()) return {};
    return features::keep(mesh, {traced.features, features::TracedPatches(traced, domain), false},
                          context);
  });
}

Features features_of(const Mesh& mesh, const PlacedDomain& domain, double angle, Context& context) {
  return features::within_memory([&] { return features::trace(mesh, domain, angle, context); }).features;
}

}  // namespace certet
