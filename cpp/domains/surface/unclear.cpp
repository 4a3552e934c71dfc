#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "certet/error.hpp"
#include "facing.hpp"
#include "inside.hpp"
#include "rounding.hpp"
#include "triangle_columns.hpp"
#include "vectors.hpp"

namespace certet {
namespace {

/// Sums over triangles, by their areas, of the winding number in their planes: the mean
/// of both sides, less one half on either.
struct Sums {
  double area = 0, behind = 0;  ///< behind: of those with more of it at their backs
  double beside = 0;            ///< regardless of the side
};

/// A little behind the centre of a triangle, in steps.
Coord3 back_of(const exact::Corners& t, const Point3& normal) {
  constexpr double little = 256;
  const auto at = [&](std::int32_t Coord3::* axis, double along) {
    const double middle = (static_cast<double>(t[0].*axis) + static_cast<double>(t[1].*axis) +
                           static_cast<double>(t[2].*axis)) / 3;
    return static_cast<std::int32_t>(std::lround(middle - little * along));
  };
  return {at(&Coord3::x, normal[0]), at(&Coord3::y, normal[1]), at(&Coord3::z, normal[2])};
}

Sums sums_over(const TriangleSurface& surface) {
  constexpr std::size_t most_triangles = 4096;
  const std::vector<Coord3> points = rounded(surface);
  const Inside inside(surface, points, Rule::half);
  const TriangleColumns columns(points, surface.triangles);
  const std::size_t stride = 1 + surface.triangles.size() / most_triangles;
  Sums sums;
  for (std::size_t n = 0; n < surface.triangles.size(); n += stride) {
    const auto& t = surface.triangles[n];
    Point3 normal = area_vector(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]);
    const double area = std::sqrt(dot(normal, normal));
    if (!(area > 0)) continue;
    for (double& along : normal) along /= area;
    const Coord3 p = back_of(columns.corners(static_cast<std::uint32_t>(n)), normal);
    constexpr auto nudge = exact::Nudge::forward;
    const double winding = inside.winding(columns.crossings(p, nudge), p, nudge) - 0.5;
    if (std::isnan(winding)) continue;
    sums.area += area;
    sums.beside += area * std::fabs(winding);
    if (winding > 0) sums.behind += area;
  }
  return sums;
}

}  // namespace

void refuse_unclear(const TriangleSurface& surface, const Context& context) {
  if (open_rule(surface) != Rule::half) return;
  constexpr double flat = 0.03, minority = 0.1, stray = 0.02, weak = 0.2;
  const Sums sums = sums_over(surface);
  if (!(sums.area > 0)) return;
  char text[160];
  if (sums.beside < flat * sums.area) {
    std::snprintf(text, sizeof text, "%.3f on average, as beside a flat sheet",
                  0.5 + sums.beside / sums.area);
    throw Error(ErrorCode::empty_domain,
                "'" + surface.name + "' is open and encloses nothing: the winding number beside "
                    "its triangles is " + text);
  }
  const std::string disagree =
      "'" + surface.name + "' is open, and its triangles do not agree which side is out: ";
  const double behind = sums.behind / sums.area;
  if (std::min(behind, 1 - behind) > minority) {
    std::snprintf(text, sizeof text,
                  "by the winding number the solid is behind %.0f %% of their area and in front "
                  "of the rest", 100 * behind);
    throw Error(ErrorCode::bad_input, disagree + text);
  }
  const Facing pieces = facing_of(surface, context);
  const double against = pieces.against * pieces.area;
  if (against >= stray) {
    std::snprintf(text, sizeof text,
                  "%.0f %% of their area face other ways than what is around them",
                  100 * against);
    throw Error(ErrorCode::bad_input, disagree + text);
  }
  if (pieces.area < 0.5 || sums.beside >= weak * sums.area) return;
  std::snprintf(text, sizeof text,
                "most touch no others, and the winding number beside them is %.3f on average",
                0.5 + sums.beside / sums.area);
  throw Error(ErrorCode::bad_input, disagree + text);
}

}  // namespace certet
