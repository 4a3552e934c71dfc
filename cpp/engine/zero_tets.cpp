#include "zero_tets.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "layer_loop.hpp"

namespace certet::core {
namespace {

/// A case of the cell at an index relative to a vertex's own.
struct CaseRef {
  Shift shift;
  std::uint8_t number;
};

/// Whether three neighbours of one corner of a case are its other corners.
constexpr bool has_triangle(const StructuredTetShape& tet, std::size_t at,
                            const std::array<std::uint8_t, 3>& triangle) {
  for (const std::uint8_t d : triangle) {
    bool found = false;
    for (const Coord3& corner : tet.vertices)
      found = found || tet.vertices[at] + tiling.directions[d] == corner;
    if (!found) return false;
  }
  return true;
}

/// The cases behind the triangles of the link of the vertices of each grid.
constexpr auto link_cases = [] {
  std::array<std::array<CaseRef, link_triangles.size()>, grid_count> cases{};
  for (std::uint8_t c = 0; c < cell_tet_count; ++c)
    for (std::size_t n = 0; n < 4; ++n)
      for (std::size_t t = 0; t < link_triangles.size(); ++t)
        if (has_triangle(tiling.tets[c], n, link_triangles[t])) {
          const auto& [grid, s] = cell.vertices[cell.corner[c][n]];
          cases[grid][t] = {{static_cast<std::int8_t>(-s.x), static_cast<std::int8_t>(-s.y),
                             static_cast<std::int8_t>(-s.z)},
                            c};
        }
  return cases;
}();

}  // namespace

Material material_of_zero_tet(const SignPlanes& planes, const CaseIndex& tet) {
  Material least = std::numeric_limits<Material>::max();
  for (std::size_t n = 0; n < 4; ++n) {
    const VertexIndex v = tet.corner(n);
    least = std::min(least, planes.materials()->at(v.grid, v.i, v.j, v.k));
  }
  return least;
}

ZeroTets::ZeroTets(const SignPlanes& planes, Context& context)
    : rows_(static_cast<std::size_t>(planes.cells()[1])) {
  if (planes.materials() == nullptr) return;
  Layers<std::vector<CaseIndex>> layers(planes.window());
  for_each_layer(context, Stage::count, planes.window(), [&](std::int32_t k) {
    for (int j = 0; j < planes.cells()[1]; ++j)
      for_each_zero_tet(planes, j, k, [&](const CaseIndex& tet) {
        if (material_of_zero_tet(planes, tet) != 0) layers[k].push_back(tet);
      });
    std::ranges::sort(layers[k]);
  });
  for (const std::vector<CaseIndex>& layer : layers)
    tets_.insert(tets_.end(), layer.begin(), layer.end());
  first_.resize(row(0, planes.cells()[2]) + 1);
  for (const CaseIndex& tet : tets_) ++first_[row(tet.j, tet.k) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

std::optional<std::uint32_t> ZeroTets::find(const CaseIndex& tet) const {
  if (tets_.empty() || tet.j < 0 || tet.k < 0) return {};
  const auto begin = tets_.begin() + first_[row(tet.j, tet.k)];
  const auto end = tets_.begin() + first_[row(tet.j, tet.k) + 1];
  const auto at = std::lower_bound(begin, end, tet);
  if (at == end || *at != tet) return {};
  return static_cast<std::uint32_t>(at - tets_.begin());
}

CaseIndex case_at(const VertexIndex& v, std::size_t triangle) {
  const auto& [shift, number] = link_cases[v.grid][triangle];
  return {v.k + shift.z, v.j + shift.y, v.i + shift.x, number};
}

}  // namespace certet::core
