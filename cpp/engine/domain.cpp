#include "certet/domain.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace certet {
namespace {

static_assert(step_bits == 16, "cuts are kept in 16 bits: 0 <= cut < steps, as BisectOnEdge says");

/// What is asked of a domain at once.
constexpr std::size_t batch = 256;

Material material_of_sign(Sign sign) { return sign == Sign::minus ? 0 : 1; }

/// Bisects many edges in lockstep, so that the domain sees long batches and the
/// loops vectorise.
class Bisection {
 public:
  /// `by_sign`: all edges leave the solid, and signs tell on which side one is.
  Bisection(const Domain& domain, bool by_sign) : domain_(domain), by_sign_(by_sign) {}

  /// `cut` is written by the next `flush`.
  void add(const PartedEdge& edge, std::uint16_t& cut) {
    start_[size_] = steps * edge.first;
    towards_[size_] = edge.last - edge.first;
    of_last_[size_] = edge.of_last;
    cut_[size_] = &cut;
    if (++size_ == batch) flush();
  }

  void flush() {
    std::fill_n(low_.begin(), size_, 0);
    std::fill_n(open_.begin(), size_, 1);
    for (int round = step_bits - 1; size_ != 0 && round >= 0; --round)
      halve(std::int32_t{1} << round);
    for (std::size_t e = 0; e < size_; ++e) *cut_[e] = static_cast<std::uint16_t>(low_[e]);
    size_ = 0;
  }

 private:
  /// One round: `low` is known to be on the side of the first end, `low` + 2 `half`
  /// on that of the last.
  void halve(std::int32_t half) {
    for (std::size_t e = 0; e < size_; ++e)
      middle_[e] = start_[e] + (low_[e] + half) * towards_[e];
    if (by_sign_) choose_by_sign(half);
    else choose_by_material(half);
  }

  /// An edge is open until a position is found to lie on the surface.
  void choose_by_sign(std::int32_t half) {
    const std::size_t n = size_;
    domain_.at({middle_.data(), n}, {signs_.data(), n});
    for (std::size_t e = 0; e < n; ++e) {
      const auto sign = static_cast<std::int32_t>(signs_[e]);
      low_[e] += half & -(open_[e] & std::int32_t{sign != static_cast<int>(Sign::minus)});
      open_[e] &= std::int32_t{sign != static_cast<int>(Sign::on_surface)};
    }
  }

  void choose_by_material(std::int32_t half) {
    const std::size_t n = size_;
    domain_.materials_at({middle_.data(), n}, {materials_.data(), n});
    for (std::size_t e = 0; e < n; ++e)
      low_[e] += half & -std::int32_t{materials_[e] != of_last_[e]};
  }

  const Domain& domain_;
  bool by_sign_;
  std::size_t size_ = 0;
  std::array<Coord3, batch> start_, towards_, middle_;
  std::array<Material, batch> of_last_, materials_;
  std::array<std::uint16_t*, batch> cut_;
  std::array<std::int32_t, batch> low_, open_;
  std::array<Sign, batch> signs_;
};

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

/// Of up to `batch` tetrahedra of a domain of several materials.
void find_materials(const Domain& domain, std::span<const TetCorners> tets,
                    std::span<Material> out) {
  std::array<Coord3, batch> centroids;
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
  Bisection of_solid(*this, true), of_materials(*this, false);
  for (std::size_t e = 0; e < edges.size(); ++e)
    (edges[e].of_last == 0 ? of_solid : of_materials).add(edges[e], out[e]);
  of_solid.flush();
  of_materials.flush();
}

void Domain::materials_of(std::span<const TetCorners> tets, std::span<Material> out) const {
  if (labels().size() <= 1) {
    std::ranges::fill(out, 1);
    return;
  }
  for (std::size_t begin = 0; begin < tets.size(); begin += batch) {
    const std::size_t count = std::min(batch, tets.size() - begin);
    find_materials(*this, tets.subspan(begin, count), out.subspan(begin, count));
  }
}

}  // namespace certet
