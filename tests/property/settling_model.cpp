#include "settling_model.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>

#include "certet/lattice/stencil.hpp"
#include "exact.hpp"

namespace settling {
namespace {

using certet::direction_count;
using certet::direction_offset;
using certet::steps;

bool adjacent(std::size_t d, std::size_t e) {
  const Coord3 difference = direction_offset[e] - direction_offset[d];
  return std::ranges::count(direction_offset, difference) != 0;
}

using Members = std::vector<std::size_t>;

/// Into how many parts some neighbours fall; `joined` says which two hang together.
template <class Joined>
int parts(const Members& members, const Joined& joined) {
  std::set<std::size_t> rest(members.begin(), members.end());
  int count = 0;
  while (!rest.empty()) {
    ++count;
    Members reached{*rest.begin()};
    rest.erase(rest.begin());
    for (std::size_t n = 0; n < reached.size(); ++n)
      for (auto it = rest.begin(); it != rest.end();)
        if (joined(reached[n], *it)) {
          reached.push_back(*it);
          it = rest.erase(it);
        } else {
          ++it;
        }
  }
  return count;
}

template <class Predicate>
Members those(const Predicate& predicate) {
  Members members;
  for (std::size_t d = 0; d < direction_count; ++d)
    if (predicate(d)) members.push_back(d);
  return members;
}

int direction_between(Coord3 a, Coord3 b) {
  const auto found = std::ranges::find(direction_offset, b - a);
  return static_cast<int>(found - direction_offset.begin());
}

constexpr std::int32_t dot(Coord3 a, Coord3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace

bool is_strict_disk(const LinkSigns& link) {
  const auto plus = [&](std::size_t d) { return link[d] == Sign::plus; };
  const auto zero = [&](std::size_t d) { return link[d] == Sign::on_surface; };
  if (parts(those(plus), adjacent) != 1) return false;
  if (parts(those([&](std::size_t d) { return !plus(d); }), adjacent) != 1) return false;
  for (const std::size_t z : those(zero)) {
    const Members ring = those([&](std::size_t d) { return adjacent(z, d); });
    const Members run = those([&](std::size_t d) { return adjacent(z, d) && plus(d); });
    if (run.size() == ring.size() || parts(run, adjacent) > 1) return false;
    for (const std::size_t other : ring) {
      if (!zero(other)) continue;
      const Members sides =
          those([&](std::size_t d) { return adjacent(z, d) && adjacent(other, d); });
      if (std::ranges::all_of(sides, plus)) return false;
    }
  }
  return true;
}

bool is_closed_disk(const LinkSigns& link) {
  const auto plus = [&](std::size_t d) { return link[d] == Sign::plus; };
  const auto zero = [&](std::size_t d) { return link[d] == Sign::on_surface; };
  // A zero belongs to the closure where a neighbour in the link is plus.
  const auto closed = [&](std::size_t d) {
    return plus(d) || (zero(d) && !those([&](std::size_t e) {
                                      return adjacent(d, e) && plus(e);
                                    }).empty());
  };
  const Members closure = those(closed);
  if (parts(closure, adjacent) != 1) return false;
  return parts(those([&](std::size_t d) { return !closed(d); }), adjacent) == 1;
}

Model::Model(const domains::Positional& domain, const Lattice& lattice, const Rule& rule)
    : domain_(domain), lattice_(lattice), rule_(rule) {
  const auto [nx, ny, nz] = lattice.cells;
  for (std::int32_t grid = 0; grid < 2; ++grid)
    for (std::int32_t k = 0; k < nz; ++k)
      for (std::int32_t j = 0; j < ny; ++j)
        for (std::int32_t i = 0; i < nx; ++i) {
          const Coord3 v = lattice.origin + 2 * Coord3{i, j, k} + Coord3{grid, grid, grid};
          vertices_.push_back(v);
          Vertex state;
          if (0 < i && i < nx - 1 && 0 < j && j < ny - 1 && 0 < k && k < nz - 1) {
            const Sign sign = domain.sign_at(steps * v);
            state.sampled = sign == Sign::plus;
            state.on_surface = sign == Sign::on_surface;
          }
          if (state.sampled) state.now = Sign::plus;
          state_.push_back(state);
        }
  for (const Coord3 v : vertices_) find_target(v);
  std::vector<std::pair<int, Coord3>> order;
  for (const Coord3 v : vertices_)
    if (at(v).direction >= 0) order.emplace_back(turn(v), v);
  std::ranges::stable_sort(order, {}, &std::pair<int, Coord3>::first);
  for (const auto& [when, v] : order) settle(v);
}

bool Model::holds(Coord3 v) const {
  const Coord3 d = v - lattice_.origin;
  const std::array<std::int32_t, 3> c{d.x, d.y, d.z};
  for (std::size_t a = 0; a < 3; ++a)
    if (c[a] < 0 || c[a] / 2 >= lattice_.cells[a]) return false;
  return true;
}

std::size_t Model::number(Coord3 v) const {
  const Coord3 d = v - lattice_.origin;
  const auto [nx, ny, nz] = lattice_.cells;
  const std::int32_t n = (((d.x & 1) * nz + d.z / 2) * ny + d.y / 2) * nx + d.x / 2;
  return static_cast<std::size_t>(n);
}

Coord3 Model::position(Coord3 v) const {
  if (sign(v) != Sign::on_surface) return steps * v;
  const Vertex& state = at(v);
  return steps * v + state.distance * direction_offset[static_cast<std::size_t>(state.direction)];
}

/// In steps from the + end, as the samples have it.
std::int32_t Model::find_cut(Coord3 plus, Coord3 minus) const {
  if (holds(minus) && at(minus).on_surface) return steps;
  std::int32_t low = 0;
  for (std::int32_t half = steps / 2; half > 0; half /= 2) {
    const Sign middle = domain_.sign_at(steps * plus + (low + half) * (minus - plus));
    if (middle != Sign::minus) low += half;
    if (middle == Sign::on_surface) break;
  }
  return low;
}

void Model::find_target(Coord3 v) {
  Vertex& state = state_[number(v)];
  std::int64_t nearest = 0;
  for (std::size_t d = 0; d < direction_count; ++d) {
    const Coord3 u = v + direction_offset[d];
    const bool other = holds(u) && at(u).sampled;
    if (other == state.sampled) continue;
    const std::int32_t t = state.sampled ? find_cut(v, u) : steps - find_cut(u, v);
    if (t >= alpha(static_cast<int>(d))) continue;
    ++state.violating;
    const std::int64_t squared = (d < 6 ? std::int64_t{4} : std::int64_t{3}) * t * t;
    if (state.direction >= 0 && squared >= nearest) continue;
    nearest = squared;
    state.direction = static_cast<int>(d);
    state.distance = t;
  }
  if (state.direction >= 0) ++figures_.violated;
}

int Model::turn(Coord3 v) const {
  const Vertex& state = at(v);
  const int bucket = 4 * state.distance / alpha(state.direction);
  const int grid = v.x & 1;
  const int parity = (v.x + v.y + v.z - grid) / 2 & 1;
  // Of the odd points those come first whose sum of coordinates, halved and rounded down,
  // is even: of (1, 1, 1) that is 1.
  return bucket * 8 + (state.sampled ? 4 : 0) + 2 * grid + parity;
}

std::int32_t Model::shortened(Coord3 v) const {
  const Vertex& state = at(v);
  const Coord3 along = direction_offset[static_cast<std::size_t>(state.direction)];
  std::int32_t reached = state.distance;
  for (std::size_t d = 6; d < direction_count; ++d) {
    const Coord3 w = v + direction_offset[d];
    if (dot(direction_offset[d], along) <= 0 || !holds(w)) continue;
    const Vertex& other = at(w);
    if (other.direction < 0) continue;
    if (direction_offset[static_cast<std::size_t>(other.direction)] + along != Coord3{}) continue;
    const std::int32_t room = 32768 - (!state.sampled && !other.sampled ? 1 : 0);
    if (sign(w) == Sign::on_surface)
      reached = std::min(reached, room - other.distance);
    else if (rule_.share && turn(w) > turn(v))
      reached = std::min(reached, (room + state.distance - other.distance) / 2);
  }
  return reached;
}

void Model::settle(Coord3 v) {
  LinkSigns link;
  for (std::size_t d = 0; d < direction_count; ++d) link[d] = sign(v + direction_offset[d]);
  if (!rule_.may_move(link)) {
    ++figures_.stayed;
    return;
  }
  Vertex& state = state_[number(v)];
  const std::int32_t target = state.distance;
  const std::int32_t reached = rule_.shorten && state.direction < 6 ? shortened(v) : target;
  if (rule_.stay && state.violating == 1 && alpha(state.direction) - target < target - reached) {
    ++figures_.stayed;
    return;
  }
  state.distance = reached;
  if (state.distance != target) {
    ++figures_.shortened;
    figures_.missed.add(target - state.distance);
  }
  state.now = Sign::on_surface;
}

std::int32_t Model::kept_cut(Coord3 plus, Coord3 minus) const {
  const std::int32_t least = alpha(direction_between(plus, minus));
  const std::int32_t found = find_cut(plus, minus);
  return rule_.clamp ? std::clamp(found, least, steps - least) : found;
}

std::int32_t Model::counted_cut(Coord3 plus, Coord3 minus) {
  const std::int32_t found = find_cut(plus, minus);
  const std::int32_t kept = kept_cut(plus, minus);
  const bool is_long = direction_between(plus, minus) < 6;
  if (kept != found)
    (is_long ? figures_.long_edges : figures_.short_edges).add(std::abs(kept - found));
  return kept;
}

template <class Visit>
void Model::for_each_tet(const Visit& visit) const {
  // Structured tetrahedra begin at even points, one cell before the first too.
  const auto [nx, ny, nz] = lattice_.cells;
  for (std::int32_t k = -1; k < nz; ++k)
    for (std::int32_t j = -1; j < ny; ++j)
      for (std::int32_t i = -1; i < nx; ++i)
        for (const certet::StructuredTetShape& shape : certet::structured_tet_table) {
          std::array<Coord3, 4> corners;
          for (std::size_t n = 0; n < 4; ++n)
            corners[n] = lattice_.origin + 2 * Coord3{i, j, k} + shape.vertices[n];
          visit(corners, shape.right_handed);
        }
}

Tets Model::mesh() {
  Tets made;
  std::map<std::pair<Coord3, Coord3>, std::uint32_t> numbers;
  const auto point = [&](Coord3 a, Coord3 b) {
    const auto [entry, is_new] =
        numbers.try_emplace({a, b}, static_cast<std::uint32_t>(made.points.size()));
    if (is_new)
      made.points.push_back(a == b ? position(a) : steps * a + counted_cut(a, b) * (b - a));
    return entry->second;
  };
  const auto cut = [this](Coord3 plus, Coord3 minus) { return kept_cut(plus, minus); };
  for_each_tet([&](const std::array<Coord3, 4>& corners, bool) {
    const certet::CornerSigns signs{sign(corners[0]), sign(corners[1]), sign(corners[2]),
                                    sign(corners[3])};
    for (const auto& tet : diagonals::tets_of(corners, signs, rule_.diagonals, cut)) {
      std::array<std::uint32_t, 4> t;
      for (std::size_t n = 0; n < 4; ++n) t[n] = point(tet[n].first, tet[n].second);
      const exact::Tet placed{made.points[t[0]], made.points[t[1]], made.points[t[2]],
                              made.points[t[3]]};
      if (exact::six_volume(placed) < 0) std::swap(t[2], t[3]);
      made.tets.push_back(t);
    }
  });
  return made;
}

bool Model::is_unfolded() const {
  bool unfolded = true;
  for_each_tet([&](const std::array<Coord3, 4>& corners, bool right_handed) {
    exact::Tet moved;
    for (std::size_t n = 0; n < 4; ++n) moved[n] = position(corners[n]);
    const exact::Wide volume = exact::six_volume(moved) * (right_handed ? 1 : -1);
    const bool all_zero = std::ranges::all_of(
        corners, [&](Coord3 v) { return sign(v) == Sign::on_surface; });
    if (volume < 0 || (volume == 0 && !all_zero)) unfolded = false;
  });
  return unfolded;
}

}  // namespace settling
