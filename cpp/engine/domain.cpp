#include "certet/domain.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace certet {
namespace {

static_assert(step_bits == 16, "cuts are kept in 16 bits: 0 <= cut < steps, as BisectOnEdge says");

/// Edges that are bisected in lockstep, so that loops vectorise.
constexpr std::size_t edges_at_once = 256;

Material material_of_sign(Sign sign) { return sign == Sign::minus ? 0 : 1; }

/// Up to so many edges.
class Bisection {
 public:
  [[nodiscard]] bool is_full() const { return size_ == edges_at_once; }
  [[nodiscard]] bool is_empty() const { return size_ == 0; }

  /// `cut` is written at the end.
  void add(const PartedEdge& edge, std::uint16_t& cut) {
    start_[size_] = steps * edge.first;
    towards_[size_] = edge.last - edge.first;
    of_last_[size_] = edge.of_last;
    cut_[size_] = &cut;
    low_[size_] = 0;
    open_[size_] = 1;
    ++size_;
  }

  /// One round: `low` is known to be on the side of the first end, `low` + 2 `half`
  /// on that of the last.  What is between them is to be asked for.
  std::span<const Coord3> middles(std::int32_t half) {
    for (std::size_t e = 0; e < size_; ++e)
      middle_[e] = start_[e] + (low_[e] + half) * towards_[e];
    return std::span(middle_).first(size_);
  }

  /// An edge is open until a position is found to lie on the surface.
  void choose(std::int32_t half, std::span<const Sign> signs) {
    for (std::size_t e = 0; e < size_; ++e) {
      const auto sign = static_cast<std::int32_t>(signs[e]);
      low_[e] += half & -(open_[e] & std::int32_t{sign != static_cast<int>(Sign::minus)});
      open_[e] &= std::int32_t{sign != static_cast<int>(Sign::on_surface)};
    }
  }

  void choose(std::int32_t half, std::span<const Material> materials) {
    for (std::size_t e = 0; e < size_; ++e)
      low_[e] += half & -std::int32_t{materials[e] != of_last_[e]};
  }

  void finish() {
    for (std::size_t e = 0; e < size_; ++e) *cut_[e] = static_cast<std::uint16_t>(low_[e]);
    size_ = 0;
  }

 private:
  std::size_t size_ = 0;
  std::array<Coord3, edges_at_once> start_, towards_, middle_;
  std::array<Material, edges_at_once> of_last_;
  std::array<std::uint16_t*, edges_at_once> cut_;
  std::array<std::int32_t, edges_at_once> low_, open_;
};

/// Calls round(half) for what becomes of the cuts bit by bit.
template <class Round>
void for_each_round(const Round& round) {
  for (int bit = step_bits - 1; bit >= 0; --bit) round(std::int32_t{1} << bit);
}

/// Some edges.  `ask(positions, answers)` asks for signs or for materials.
template <class Answer, class Ask>
void bisect(Bisection& edges, const Ask& ask) {
  std::array<Answer, edges_at_once> answers;
  for_each_round([&](std::int32_t half) {
    const std::span<const Coord3> middles = edges.middles(half);
    const std::span<Answer> own = std::span(answers).first(middles.size());
    ask(middles, own);
    edges.choose(half, std::span<const Answer>(own));
  });
  edges.finish();
}

/// Many edges, all in lockstep, for a domain that likes to be asked for many positions.
template <class Answer, class Ask>
void bisect(std::span<Bisection> edges, const Ask& ask) {
  std::vector<Coord3> positions;
  std::vector<Answer> answers;
  for_each_round([&](std::int32_t half) {
    positions.clear();
    for (Bisection& some : edges) {
      const std::span<const Coord3> middles = some.middles(half);
      positions.insert(positions.end(), middles.begin(), middles.end());
    }
    answers.resize(positions.size());
    ask(positions, std::span(answers));
    auto answer = answers.cbegin();
    for (Bisection& some : edges) {
      const auto size = static_cast<std::ptrdiff_t>(some.middles(half).size());
      some.choose(half, std::span<const Answer>(answer, answer + size));
      answer += size;
    }
  });
  for (Bisection& some : edges) some.finish();
}

/// Finds the cuts of the edges of which is_wanted(edge).
template <class Answer, class IsWanted, class Ask>
void part_some(std::span<const PartedEdge> edges, std::span<std::uint16_t> out, std::size_t batch,
               const IsWanted& is_wanted, const Ask& ask) {
  if (batch > edges_at_once) {
    std::vector<Bisection> all;
    all.reserve(edges.size() / edges_at_once + 1);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (!is_wanted(edges[e])) continue;
      if (all.empty() || all.back().is_full()) all.emplace_back();
      all.back().add(edges[e], out[e]);
    }
    if (!all.empty()) bisect<Answer>(std::span(all), ask);
    return;
  }
  Bisection some;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!is_wanted(edges[e])) continue;
    some.add(edges[e], out[e]);
    if (some.is_full()) bisect<Answer>(some, ask);
  }
  if (!some.is_empty()) bisect<Answer>(some, ask);
}

using Sum = std::array<std::int64_t, 3>;

/// Four times the centroid, in steps.
Sum sum_of(const TetCorners& corners) {
  Sum sum{};
  for (const Coord3 corner : corners) {
    sum[0] += corner.x;
    sum[1] += corner.y;
    sum[2] += corner.z;
  }
  return sum;
}

/// How far a corner is from the centroid; squared, of four times the distance along
/// each axis.  A tetrahedron of the mesh is no longer than four lattice units.
std::int64_t distance(Coord3 corner, const Sum& sum) {
  const std::int64_t x = 4 * std::int64_t{corner.x} - sum[0];
  const std::int64_t y = 4 * std::int64_t{corner.y} - sum[1];
  const std::int64_t z = 4 * std::int64_t{corner.z} - sum[2];
  return x * x + y * y + z * z;
}

/// `materials` are those of the corners.
Material of_nearest_corner(const TetCorners& corners, std::span<const Material, 4> materials) {
  const Sum sum = sum_of(corners);
  Material nearest = 0;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (std::size_t v = 0; v < 4; ++v) {
    const std::int64_t far = distance(corners[v], sum);
    if (materials[v] == 0 || far >= least) continue;
    nearest = materials[v];
    least = far;
  }
  return nearest;
}

/// Of up to `edges_at_once` tetrahedra of a domain of several materials.
void find_materials(const Domain& domain, std::span<const TetCorners> tets,
                    std::span<Material> out) {
  std::array<Coord3, edges_at_once> centroids;
  for (std::size_t i = 0; i < tets.size(); ++i) {
    const Sum sum = sum_of(tets[i]);
    centroids[i] = {static_cast<std::int32_t>(sum[0] >> 2), static_cast<std::int32_t>(sum[1] >> 2),
                    static_cast<std::int32_t>(sum[2] >> 2)};
  }
  domain.materials_at(std::span(centroids).first(tets.size()), out);
  for (std::size_t i = 0; i < tets.size(); ++i) {
    if (out[i] != 0) continue;
    std::array<Material, 4> of_corners;
    domain.materials_at(tets[i], of_corners);
    out[i] = of_nearest_corner(tets[i], of_corners);
  }
}

}  // namespace

void Domain::row_materials(Coord3 first, std::span<Material> out) const {
  std::vector<Sign> signs(out.size());
  row(first, signs);
  std::ranges::transform(signs, out.begin(), material_of_sign);
}

void Domain::materials_at(std::span<const Coord3> positions, std::span<Material> out) const {
  std::vector<Sign> signs(out.size());
  at(positions, signs);
  std::ranges::transform(signs, out.begin(), material_of_sign);
}

std::optional<Material> Domain::material_of(const LatticeBox& box) const {
  switch (extent(box)) {
    case Extent::outside: return 0;
    case Extent::inside: return labels().size() > 1 ? std::nullopt : std::optional<Material>(1);
    case Extent::mixed: break;
  }
  return std::nullopt;
}

void Domain::part(std::span<const PartedEdge> edges, std::span<std::uint16_t> out) const {
  part_some<Sign>(
      edges, out, batch(), [](const PartedEdge& edge) { return edge.of_last == 0; },
      [this](std::span<const Coord3> positions, std::span<Sign> signs) { at(positions, signs); });
  part_some<Material>(
      edges, out, batch(), [](const PartedEdge& edge) { return edge.of_last != 0; },
      [this](std::span<const Coord3> positions, std::span<Material> materials) {
        materials_at(positions, materials);
      });
}

void Domain::materials_of(std::span<const TetCorners> tets, std::span<Material> out) const {
  if (labels().size() <= 1) {
    std::ranges::fill(out, 1);
    return;
  }
  for (std::size_t begin = 0; begin < tets.size(); begin += edges_at_once) {
    const std::size_t count = std::min(edges_at_once, tets.size() - begin);
    find_materials(*this, tets.subspan(begin, count), out.subspan(begin, count));
  }
}

}  // namespace certet
