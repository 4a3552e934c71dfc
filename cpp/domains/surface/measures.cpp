#include <algorithm>
#include <cmath>

#include "certet/surface.hpp"
#include "chords.hpp"
#include "edges.hpp"
#include "inside.hpp"
#include "surface_box.hpp"
#include "vectors.hpp"

namespace certet {
namespace {

/// By the divergence theorem: each part as often as the surface winds around it.
double wound_volume(const TriangleSurface& surface) {
  const Point3& origin = surface.points[surface.triangles[0][0]];
  double sum = 0;
  for (const auto& t : surface.triangles) {
    const Point3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    sum += dot(difference(a, origin), area_vector(a, b, c));
  }
  return sum / 6;
}

/// What so large a share of the surface has behind it, or less.
double quantile(std::vector<Thickness> behind, double share) {
  if (behind.empty()) return 0;
  std::sort(behind.begin(), behind.end(),
            [](const Thickness& a, const Thickness& b) { return a.thick < b.thick; });
  double all = 0, so_far = 0;
  for (const Thickness& one : behind) all += one.area;
  for (const Thickness& one : behind)
    if ((so_far += one.area) >= share * all) return one.thick;
  return behind.back().thick;
}

/// Whether a default may go to this size: tetrahedra by what plates and balls of many
/// thicknesses have, and cells of the lattice around them.
bool allowed(const SurfaceMeasures& solid, const Point3& sides, double size) {
  const double tets =
      12 * solid.volume / (size * size * size) + 3 * solid.area / (size * size);
  double cells = 1;
  for (const double side : sides) cells *= side / size + 4;
  return tets <= most_default_tets && cells <= most_default_cells;
}

}  // namespace

SurfaceMeasures measure(const TriangleSurface& surface, const Context& context) {
  refuse_malformed(surface);
  constexpr double thin_share = 0.02;
  const Rule rule = open_rule(surface);
  const Chords chords = find_chords(surface, rule, context);
  SurfaceMeasures result;
  // Lines along three axes measured the same solid.
  result.volume = rule != Rule::winding || chords.wound == 0
                      ? chords.inside / 3
                      : std::fabs(wound_volume(surface)) * (chords.inside / std::fabs(chords.wound));
  for (const auto& t : surface.triangles)
    result.area += length(area_vector(surface.points[t[0]], surface.points[t[1]],
                                      surface.points[t[2]])) / 2;
  result.thin = quantile(chords.behind, thin_share);
  return result;
}

SurfaceSize default_size(const TriangleSurface& surface, const SurfaceMeasures& solid) {
  constexpr double across_thin = 4;
  SurfaceSize result;
  const Point3 box = SurfaceBox(surface).sides();
  result.usual = result.size = result.wanted = *std::max_element(box.begin(), box.end()) / 64;
  const double for_thin = solid.thin / across_thin;
  if (!(for_thin > 0) || for_thin >= result.usual) return result;
  result.wanted = for_thin;
  double coarse = result.size, fine = result.wanted;
  if (allowed(solid, box, fine)) coarse = fine;
  for (int i = 0; i < 40 && fine < coarse; ++i) {
    const double middle = std::sqrt(coarse * fine);
    (allowed(solid, box, middle) ? coarse : fine) = middle;
  }
  result.size = coarse;
  return result;
}

}  // namespace certet
