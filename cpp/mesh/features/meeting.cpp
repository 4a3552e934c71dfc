#include "meeting.hpp"

#include <array>
#include <cmath>

#include "engine/parallel.hpp"

namespace certet::features {
namespace {

/// Steps between rays onto a face, round after round: what a face is bent within twice that is
/// what its plane misses the line by.
constexpr std::array<double, 5> strides{8192, 4096, 2048, 1024, 1024};
/// A face that turns by more than so many degrees within these is not the same one.
constexpr double still_same = 35;
/// Steps, from a guess, and in the last round.
constexpr double farthest_line = 0.3 * long_edge, farthest_corner = 1.2 * long_edge, near_enough = 32;

struct Plane {
  Vector point, normal;
};

/// The tangent plane of a face beside a place, by three rays.
std::optional<Plane> plane_beside(const Domain& domain, const Vector& place, const Vector& normal,
                                  const Vector& into, double stride) {
  const Vector aside = cross(normal, into);
  const std::array<Ray, 3> rays{{{place + stride * into, normal, 2 * stride},
                                 {place + 2 * stride * into, normal, 3 * stride},
                                 {place + stride * (1.5 * into + 0.3 * aside), normal, 3 * stride}}};
  std::array<Hit, 3> hits;
  cast(domain, rays, hits);
  for (const Hit& hit : hits)
    if (!hit.found) return std::nullopt;
  const Vector seen = unit(cross(hits[1].place - hits[0].place, hits[2].place - hits[0].place));
  if (seen == Vector{0, 0, 0} || angle_between(seen, normal) > still_same) return std::nullopt;
  return Plane{hits[0].place, seen};
}

/// Where three planes meet, unless two are nearly parallel.
std::optional<Vector> meeting_of(const Plane& a, const Plane& b, const Plane& c) {
  const double volume = dot(a.normal, cross(b.normal, c.normal));
  if (std::fabs(volume) < 0.02) return std::nullopt;
  return (1 / volume) * (dot(a.point, a.normal) * cross(b.normal, c.normal) +
                         dot(b.point, b.normal) * cross(c.normal, a.normal) +
                         dot(c.point, c.normal) * cross(a.normal, b.normal));
}

std::optional<OnLine> onto_line(const Domain& domain, const OnLine& guess) {
  OnLine own = guess;
  double by = 0;
  for (const double stride : strides) {
    std::array<Plane, 2> planes;
    for (std::size_t face = 0; face < 2; ++face) {
      const auto plane =
          plane_beside(domain, own.place, own.wedge.normals[face], own.wedge.into(face), stride);
      if (!plane) return std::nullopt;
      planes[face] = *plane;
    }
    own.wedge.normals = {planes[0].normal, planes[1].normal};
    const auto place = meeting_of(planes[0], planes[1], {guess.place, own.along()});
    if (!place || length(*place - guess.place) > farthest_line) return std::nullopt;
    by = length(*place - own.place);
    own.place = *place;
  }
  if (by > near_enough) return std::nullopt;
  return own;
}

}  // namespace

std::vector<std::optional<OnLine>> onto_lines(const Domain& domain, std::span<const OnLine> guesses,
                                              Context& context) {
  std::vector<std::optional<OnLine>> found(guesses.size());
  core::parallel_for(context, Stage::emit, static_cast<std::int64_t>(guesses.size()),
                     [&](std::int64_t i) {
                       const auto at = static_cast<std::size_t>(i);
                       found[at] = onto_line(domain, guesses[at]);
                     });
  return found;
}

std::optional<Vector> onto_corner(const Domain& domain, const Vector& guess,
                                  std::array<CornerFace, 3> faces) {
  Vector own = guess;
  double by = 0;
  for (const double stride : strides) {
    std::array<Plane, 3> planes;
    for (std::size_t face = 0; face < 3; ++face) {
      auto& [normal, into] = faces[face];
      const auto plane = plane_beside(domain, own, normal, unit(into - dot(into, normal) * normal), stride);
      if (!plane) return std::nullopt;
      planes[face] = *plane;
      normal = plane->normal;
    }
    const auto place = meeting_of(planes[0], planes[1], planes[2]);
    if (!place || length(*place - guess) > farthest_corner) return std::nullopt;
    by = length(*place - own);
    own = *place;
  }
  if (by > near_enough) return std::nullopt;
  return own;
}

}  // namespace certet::features
