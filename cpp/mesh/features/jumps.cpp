#include "jumps.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/parallel.hpp"

namespace certet::features {
namespace {

/// Two vertices may turn by so much less than the edge between them does, as faces are bent on the way
/// to it.
constexpr double slack = 0.25;
/// Halvings, after which two places are a 128th of an edge apart.
constexpr int halvings = 8;

/// Two places on the surface, between which it turns.
struct Turn {
  std::array<std::uint32_t, 2> ends;
  std::array<Vector, 2> places, normals;
  bool lost = false;  ///< no surface was found in between
};

std::vector<Turn> candidates(const SeenSurface& surface, double angle, const MayJump& may_jump) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const auto& [a, b, c] : surface.triangles)
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      if (surface.known[from] != 0 && surface.known[to] != 0)
        edges.push_back({std::min(from, to), std::max(from, to)});
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<Turn> turns;
  for (const auto& [v, w] : edges)
    if (angle_between(surface.normals[v], surface.normals[w]) > slack * angle && may_jump(v, w))
      turns.push_back({{v, w},
                       {surface.places[v], surface.places[w]},
                       {surface.normals[v], surface.normals[w]}});
  return turns;
}

/// Middles between the places of turns, moved onto the surface.
std::vector<Look> middles_of(const Domain& domain, std::vector<Turn>& turns, Context& context) {
  std::vector<Look> looks(turns.size());
  core::parallel_for(context, Stage::emit, static_cast<std::int64_t>(turns.size()),
                     [&](std::int64_t task) {
    const auto i = static_cast<std::size_t>(task);
    Turn& turn = turns[i];
    const Vector axis = unit(turn.normals[0] + turn.normals[1]);
    const Ray ray{0.5 * (turn.places[0] + turn.places[1]), axis,
                  2 * length(turn.places[1] - turn.places[0]) + 64};
    const Hit hit = turn.lost || axis == Vector{0, 0, 0} ? Hit{} : cast(domain, ray);
    turn.lost = !hit.found;
    looks[i] = {hit.found ? hit.place : ray.origin, axis};
  });
  return looks;
}

void halve(const Domain& domain, std::vector<Turn>& turns, Context& context) {
  const std::vector<Look> looks = middles_of(domain, turns, context);
  const auto seen = facing(domain, looks, context);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    Turn& turn = turns[i];
    if (!seen[i]) turn.lost = true;
    if (turn.lost) continue;
    const std::size_t like = angle_between(seen[i]->normal, turn.normals[0]) <=
                                     angle_between(seen[i]->normal, turn.normals[1])
                                 ? 0
                                 : 1;
    turn.places[like] = seen[i]->place;
    if (seen[i]->smooth) turn.normals[like] = seen[i]->normal;
  }
  std::erase_if(turns, [](const Turn& turn) { return turn.lost; });
}

/// Beyond the edge of the first face, a little below: outside of a convex wedge.
Coord3 beyond(const Turn& turn) {
  constexpr double away = 8192, below = 0.25;
  const auto& [m, n] = turn.normals;
  const Vector past = unit(n - dot(m, n) * m);
  const double depth = below * std::min(1.0, length(cross(m, n)));
  return in_steps(0.5 * (turn.places[0] + turn.places[1]) + away * past - (away * depth) * m);
}

}  // namespace

Vector Wedge::into(std::size_t face) const {
  const Vector &own = normals[face], &other = normals[1 - face];
  const Vector past = unit(other - dot(own, other) * own);
  return convex ? -1.0 * past : past;
}

std::vector<Jump> find_jumps(const SeenSurface& surface, const Domain& domain, double angle,
                             const MayJump& may_jump, Context& context) {
  std::vector<Turn> turns = candidates(surface, angle, may_jump);
  for (int i = 0; i < halvings; ++i) halve(domain, turns, context);
  std::erase_if(turns, [&](const Turn& turn) {
    return angle_between(turn.normals[0], turn.normals[1]) <= angle;
  });
  std::vector<Coord3> asked;
  for (const Turn& turn : turns) asked.push_back(beyond(turn));
  std::vector<Sign> signs(asked.size());
  domain.at(asked, signs);
  std::vector<Jump> jumps;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const Turn& turn = turns[i];
    jumps.push_back({turn.ends,
                     0.5 * (turn.places[0] + turn.places[1]),
                     {turn.normals, signs[i] == Sign::minus}});
  }
  return jumps;
}

}  // namespace certet::features
