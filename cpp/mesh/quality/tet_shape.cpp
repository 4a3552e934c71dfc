#include "certet/tet_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace certet {
namespace {

using Vector = Point3;

Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

using Corners = std::array<Point3, 4>;

std::array<double, 6> squared_edges(const Corners& p) {
  const auto squared = [&p](std::size_t i, std::size_t j) {
    const Vector edge = p[j] - p[i];
    return dot(edge, edge);
  };
  return {squared(0, 1), squared(0, 2), squared(0, 3),
          squared(1, 2), squared(1, 3), squared(2, 3)};
}

/// Inward or outward, all alike; as long as twice the face's area.
std::array<Vector, 4> normals(const Corners& p) {
  const Vector a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  return {cross(b - a, c - a), cross(c, b), cross(a, c), cross(b, a)};
}

double aspect_of(const Corners& p, const std::array<Vector, 4>& normals, double longest_squared) {
  const double six_volume = std::fabs(dot(p[3] - p[0], normals[3]));
  double face = 0;
  for (const Vector& n : normals) face = std::max(face, dot(n, n));
  if (!(six_volume > 0)) return std::numeric_limits<double>::infinity();
  return std::sqrt(longest_squared * face) / six_volume;
}

Corners corners_of(std::span<const Point3> points, const Tet<std::uint64_t>& tet) {
  return {points[tet[0]], points[tet[1]], points[tet[2]], points[tet[3]]};
}

/// The last one for all that is beyond, and for what is no number.
std::size_t bin_of(double bin, int bins) {
  return bin < bins - 1 ? static_cast<std::size_t>(std::max(bin, 0.0))
                        : static_cast<std::size_t>(bins - 1);
}

/// First what is extreme, which the bins of the edges hang on.
void survey_extremes(std::span<const Point3> points, std::span<const Tet<std::uint64_t>> tets,
                     ShapeSurvey& survey) {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for (const auto& tet : tets) {
    if (!has_corners(points, tet)) continue;
    const Corners corners = corners_of(points, tet);
    const auto edges = squared_edges(corners);
    const auto [least, greatest] = std::ranges::minmax(edges);
    shortest = std::min(shortest, least);
    longest = std::max(longest, greatest);
    const double aspect = aspect_of(corners, normals(corners), greatest);
    survey.greatest_aspect = std::max(survey.greatest_aspect, aspect);
    ++survey.aspects[bin_of((aspect - 1) / ShapeSurvey::aspect_step, ShapeSurvey::aspect_bins)];
    ++survey.tets;
  }
  if (survey.tets == 0) return;
  survey.shortest_edge = std::sqrt(shortest);
  survey.longest_edge = std::sqrt(longest);
}

void survey_edges(std::span<const Point3> points, std::span<const Tet<std::uint64_t>> tets,
                  ShapeSurvey& survey) {
  const double width = survey.longest_edge - survey.shortest_edge;
  const double bins_per_length = width > 0 ? ShapeSurvey::edge_bins / width : 0;
  for (const auto& tet : tets) {
    if (!has_corners(points, tet)) continue;
    for (const double squared : squared_edges(corners_of(points, tet))) {
      const double bin = (std::sqrt(squared) - survey.shortest_edge) * bins_per_length;
      ++survey.edges[bin_of(bin, ShapeSurvey::edge_bins)];
    }
  }
}

}  // namespace

double TetShape::worst_angle() const {
  return std::min(least_dihedral, 180 - greatest_dihedral);
}

TetShape shape_of(const Corners& corners) {
  const auto [least, greatest] = std::ranges::minmax(squared_edges(corners));
  const auto n = normals(corners);
  double smallest_cosine = 1, largest_cosine = -1;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double cosine = -dot(n[i], n[j]) / std::sqrt(dot(n[i], n[i]) * dot(n[j], n[j]));
      if (std::isnan(cosine)) return {cosine, cosine, aspect_of(corners, n, greatest),
                                      std::sqrt(least), std::sqrt(greatest)};
      smallest_cosine = std::min(smallest_cosine, cosine);
      largest_cosine = std::max(largest_cosine, cosine);
    }
  constexpr double degrees = 180 / std::numbers::pi;
  return {std::acos(largest_cosine) * degrees, std::acos(smallest_cosine) * degrees,
          aspect_of(corners, n, greatest), std::sqrt(least), std::sqrt(greatest)};
}

ShapeSurvey survey_shapes(std::span<const Point3> points,
                          std::span<const Tet<std::uint64_t>> tets) {
  ShapeSurvey survey;
  survey_extremes(points, tets, survey);
  survey_edges(points, tets, survey);
  return survey;
}

}  // namespace certet
