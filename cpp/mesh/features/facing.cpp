#include "facing.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "engine/parallel.hpp"

namespace certet::features {
namespace {

/// Of the ray in the middle: settling may have put a vertex beside the surface.
constexpr double middle_reach = 0.4 * long_edge;
/// Rays around that, in steps: far enough for a normal to be known to a tenth of a degree.
constexpr double around = 1024, looking_reach = 6 * around;
constexpr std::size_t ring = 24;
using Hits = std::span<const Hit, ring>;
/// Three rays so far from each other tell a normal; the one in the middle has no part in it, as that
/// may be near the end of its face.
constexpr std::size_t stride = ring / 8;
using Normals = std::array<std::optional<Vector>, ring>;

/// In degrees: normals all around a smooth place, and two neighbours on one face.
constexpr double smooth_within = 8, same_face = 4;

Normals normals_of(Hits hits) {
  Normals normals;
  for (std::size_t i = 0; i < ring; ++i) {
    const Hit &a = hits[i], &b = hits[(i + stride) % ring], &c = hits[(i + 2 * stride) % ring];
    if (!a.found || !b.found || !c.found) continue;
    const Vector normal = unit(cross(b.place - a.place, c.place - a.place));
    if (normal != Vector{0, 0, 0}) normals[i] = normal;
  }
  return normals;
}

/// Where faces meet, always one on the same side: of those that two neighbours agree on, or of
/// all, what is farthest along a direction that no shape is aligned with.
std::optional<Vector> one_of(const Normals& normals) {
  constexpr Vector aside{0.5313, 0.3571, 0.7683};
  std::optional<Vector> best;
  for (const bool any : {false, true}) {
    for (std::size_t i = 0; i < ring; ++i) {
      const auto &own = normals[i], &next = normals[(i + 1) % ring];
      if (!own || (!any && (!next || angle_between(*own, *next) > same_face))) continue;
      if (!best || dot(*own, aside) > dot(*best, aside)) best = own;
    }
    if (best) break;
  }
  return best;
}

std::optional<Facing> facing_of(const Hit& middle, Hits hits) {
  if (!middle.found) return std::nullopt;
  const auto normals = normals_of(hits);
  Vector sum{0, 0, 0};
  bool all = true;
  for (const auto& normal : normals) {
    all = all && normal;
    if (normal) sum = sum + *normal;
  }
  const Vector mean = unit(sum);
  for (const auto& normal : normals) all = all && angle_between(*normal, mean) <= smooth_within;
  if (all) return Facing{middle.place, mean, true};
  const auto one = one_of(normals);
  if (!one) return std::nullopt;
  return Facing{middle.place, *one, false};
}

}  // namespace

Vector unit(const Vector& a) {
  const double size = length(a);
  return size > 0 ? (1 / size) * a : Vector{0, 0, 0};
}

double angle_between(const Vector& a, const Vector& b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * (180 / std::numbers::pi);
}

std::array<Vector, 2> across(const Vector& axis) {
  const std::size_t least = std::fabs(axis[0]) <= std::fabs(axis[1])
                                ? (std::fabs(axis[0]) <= std::fabs(axis[2]) ? 0 : 2)
                                : (std::fabs(axis[1]) <= std::fabs(axis[2]) ? 1 : 2);
  Vector other{0, 0, 0};
  other[least] = 1;
  const Vector first = unit(cross(axis, other));
  return {first, cross(axis, first)};
}

std::vector<std::optional<Facing>> facing(const Domain& domain, std::span<const Look> looks,
                                          Context& context) {
  constexpr std::size_t at_once = 64;
  std::vector<std::optional<Facing>> found(looks.size());
  const auto tasks = static_cast<std::int64_t>((looks.size() + at_once - 1) / at_once);
  core::parallel_for(context, Stage::emit, tasks, [&](std::int64_t task) {
    const std::size_t begin = static_cast<std::size_t>(task) * at_once,
                      end = std::min(begin + at_once, looks.size());
    std::vector<Ray> rays;
    for (std::size_t i = begin; i < end; ++i)
      rays.push_back({looks[i].place, looks[i].axis, middle_reach});
    std::vector<Hit> middles(rays.size()), hits(ring * rays.size());
    cast(domain, rays, middles);
    rays.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const auto [u, v] = across(looks[i].axis);
      const Hit& middle = middles[i - begin];
      for (std::size_t s = 0; s < ring; ++s) {
        const double turn = 2 * std::numbers::pi * static_cast<double>(s) / ring;
        const Vector aside = (around * std::cos(turn)) * u + (around * std::sin(turn)) * v;
        rays.push_back({middle.place + aside, looks[i].axis, middle.found ? looking_reach : 0});
      }
    }
    cast(domain, rays, hits);
    for (std::size_t i = begin; i < end; ++i)
      found[i] = facing_of(middles[i - begin], Hits(hits.data() + ring * (i - begin), ring));
  });
  return found;
}

}  // namespace certet::features
