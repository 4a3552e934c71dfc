#include "facing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "arc.hpp"
#include "inside.hpp"
#include "rounding.hpp"
#include "triangle_columns.hpp"
#include "vectors.hpp"

namespace certet {
namespace {

/// Pieces of more triangles tell by their own edges how they face.
constexpr std::size_t few = 16;

/// By the formula of van Oosterom and Strackee, as a part of the sphere.
double covered(const exact::Corners& t, const Point3& from) {
  std::array<Point3, 3> v;
  std::array<double, 3> far;
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = difference({double(t[i].x), double(t[i].y), double(t[i].z)}, from);
    far[i] = std::sqrt(dot(v[i], v[i]));
  }
  return angle_in_turns(dot(v[0], cross(v[1], v[2])),
                        far[0] * far[1] * far[2] + dot(v[0], v[1]) * far[2] +
                            dot(v[1], v[2]) * far[0] + dot(v[2], v[0]) * far[1]);
}

/// Of each piece of few triangles its triangles, of others none.
std::vector<std::vector<std::uint32_t>> small_pieces(const SurfacePatches& patches) {
  std::vector<std::vector<std::uint32_t>> pieces(patches.count);
  for (std::uint32_t t = 0; t < patches.of.size(); ++t) {
    auto& piece = pieces[patches.of[t]];
    if (piece.size() <= few) piece.push_back(t);
  }
  std::erase_if(pieces, [](const auto& piece) { return piece.empty() || piece.size() > few; });
  return pieces;
}

/// The field of a surface as it is.
class Field {
 public:
  explicit Field(const TriangleSurface& surface)
      : points_(rounded(surface)), columns_(points_, surface.triangles),
        inside_(surface, points_, Rule::half) {}

  struct Fall {
    double area = 0, sum = 0;
  };

  /// How far the winding number of all but a piece falls through it, by areas.
  [[nodiscard]] Fall fall(const std::vector<std::uint32_t>& piece) const {
    Fall result;
    for (const std::uint32_t t : piece) {
      const exact::Corners corners = columns_.corners(t);
      const exact::Normal n = exact::normal(corners);
      Point3 normal{double(n.x), double(n.y), double(n.z)};
      const double area = std::sqrt(dot(normal, normal));
      if (!(area > 0)) continue;
      // A part of the triangle's height, so that its own hole is what is seen.
      constexpr double height_share = 0.1;
      const double step = height_share * area / longest(corners);
      for (double& along : normal) along *= step / area;
      const double one = without(piece, corners, normal, -1) - without(piece, corners, normal, 1);
      result.area += area;
      // More is another sheet close by.
      if (std::fabs(one) < 0.5) result.sum += area * one;
    }
    return result;
  }

 private:
  static double longest(const exact::Corners& t) {
    double square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Coord3 a = t[i], b = t[(i + 1) % 3];
      const Point3 edge{double(exact::gap(a.x, b.x)), double(exact::gap(a.y, b.y)),
                        double(exact::gap(a.z, b.z))};
      square = std::max(square, dot(edge, edge));
    }
    return std::sqrt(square);
  }

  /// The winding number without a piece, on one side of a triangle of it.
  [[nodiscard]] double without(const std::vector<std::uint32_t>& piece, const exact::Corners& t,
                               const Point3& normal, double side) const {
    const auto at = [&](std::int32_t Coord3::* axis, double along) {
      const double sum = double(t[0].*axis) + double(t[1].*axis) + double(t[2].*axis);
      return static_cast<std::int32_t>(std::lround(sum / 3 + side * along));
    };
    const Coord3 p{at(&Coord3::x, normal[0]), at(&Coord3::y, normal[1]), at(&Coord3::z, normal[2])};
    double winding = inside_.winding(columns_.crossings(p, exact::Nudge::forward), p,
                                     exact::Nudge::forward);
    const Point3 from{double(p.x), double(p.y), double(p.z)};
    for (const std::uint32_t own : piece) winding -= covered(columns_.corners(own), from);
    return std::isnan(winding) ? 0 : winding;
  }

  std::vector<Coord3> points_;
  TriangleColumns columns_;
  Inside inside_;
};

double area_of(const TriangleSurface& surface, std::uint32_t triangle) {
  const auto& [a, b, c] = surface.triangles[triangle];
  const Point3 twice = area_vector(surface.points[a], surface.points[b], surface.points[c]);
  return std::sqrt(dot(twice, twice)) / 2;
}

/// Far more than what is lost where rims are far.
bool is_against(const Field::Fall& fall) { return fall.sum < -0.02 * fall.area; }

}  // namespace

std::uint64_t face_as_others(TriangleSurface& surface, const SurfacePatches& patches,
                             const Context& context) {
  constexpr int most_rounds = 8;
  const auto pieces = small_pieces(patches);
  if (pieces.size() < 2) return 0;
  std::vector<bool> turned(pieces.size(), false);
  for (int round = 0; round < most_rounds; ++round) {
    const Field field(surface);
    bool any = false;
    for (std::size_t n = 0; n < pieces.size(); ++n) {
      stop_if_cancelled(context);
      if (!is_against(field.fall(pieces[n]))) continue;
      any = true;
      turned[n] = !turned[n];
      for (const std::uint32_t t : pieces[n])
        std::swap(surface.triangles[t][1], surface.triangles[t][2]);
    }
    if (!any) break;
  }
  std::uint64_t count = 0;
  for (std::size_t n = 0; n < pieces.size(); ++n)
    if (turned[n]) count += pieces[n].size();
  return count;
}

Facing facing_of(const TriangleSurface& surface, const Context& context) {
  constexpr std::size_t most_pieces = 4096;
  TriangleSurface as_it_is = surface;
  std::uint64_t turned = 0;
  const auto pieces = small_pieces(agreed_patches(as_it_is, turned));
  if (pieces.size() < 2) return {};
  const Field field(surface);
  double area = 0, against = 0, of_pieces = 0;
  for (std::size_t n = 0; n < pieces.size(); n += 1 + pieces.size() / most_pieces) {
    stop_if_cancelled(context);
    const Field::Fall fall = field.fall(pieces[n]);
    area += fall.area;
    if (is_against(fall)) against += fall.area;
  }
  for (const auto& piece : pieces)
    for (const std::uint32_t t : piece) of_pieces += area_of(surface, t);
  double all = 0;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) all += area_of(surface, t);
  return {all > 0 ? of_pieces / all : 0, area > 0 ? against / area : 0};
}

}  // namespace certet
