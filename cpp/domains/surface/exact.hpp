#pragma once
/// \file
/// Where points lie with respect to triangles, decided in whole numbers.
///
/// Coordinates have 32 bits, so that a difference has 33, the normal of a
/// triangle 67, and a product of the two 102.
///
/// Rays run along x.  A ray that meets an edge or a corner is moved aside, by
/// (e^3, e, e^2) for an e that is less than any number, or by its opposite:
/// `Nudge` says which.  All triangles are asked about the same moved ray, so that
/// it passes through one of those that share an edge, never both or none.

#include <array>
#include <cstdint>

#include "certet/lattice/coord3.hpp"

namespace certet::exact {

__extension__ using Wide = __int128;

/// The corners of a triangle, in steps.
using Corners = std::array<Coord3, 3>;

enum class Nudge : int { forward = 1, backward = -1 };

constexpr int sign_of(Wide number) { return (number > 0) - (number < 0); }

constexpr std::int64_t gap(std::int32_t from, std::int32_t to) {
  return std::int64_t{to} - from;
}

/// The side of the line a b, seen along x, on which p lies: 1, -1, or 0 for on it.
constexpr int side(Coord3 a, Coord3 b, Coord3 p) {
  return sign_of(Wide{gap(a.y, b.y)} * gap(a.z, p.z) - Wide{gap(a.z, b.z)} * gap(a.y, p.y));
}

/// The same of a p that was moved; 0 only if a and b are the same seen along x.
constexpr int side(Coord3 a, Coord3 b, Coord3 p, Nudge nudge) {
  if (const int exact = side(a, b, p)) return exact;
  if (a.z != b.z) return (a.z > b.z ? 1 : -1) * static_cast<int>(nudge);
  return sign_of(gap(a.y, b.y)) * static_cast<int>(nudge);
}

/// Twice the area vector.
struct Normal {
  Wide x, y, z;
};

constexpr Normal normal(const Corners& t) {
  const std::int64_t ux = gap(t[0].x, t[1].x), uy = gap(t[0].y, t[1].y),
                     uz = gap(t[0].z, t[1].z), vx = gap(t[0].x, t[2].x),
                     vy = gap(t[0].y, t[2].y), vz = gap(t[0].z, t[2].z);
  return {Wide{uy} * vz - Wide{uz} * vy, Wide{uz} * vx - Wide{ux} * vz,
          Wide{ux} * vy - Wide{uy} * vx};
}

/// Positive where p lies on the side of the plane that the normal points to.
constexpr Wide height(const Corners& t, const Normal& n, Coord3 p) {
  return n.x * gap(t[0].x, p.x) + n.y * gap(t[0].y, p.y) + n.z * gap(t[0].z, p.z);
}

/// Whether the line along x through a moved p passes through the triangle: 1 if
/// it leaves the solid there as x grows, -1 if it enters, 0 if it passes by.
constexpr int passing(const Corners& t, Coord3 p, Nudge nudge) {
  const int first = side(t[0], t[1], p, nudge);
  if (first == 0 || side(t[1], t[2], p, nudge) != first || side(t[2], t[0], p, nudge) != first)
    return 0;
  return first;
}

/// Given that the line passes, as `direction` says: whether it does at a greater
/// x than that of the moved p.
constexpr bool ahead(const Corners& t, const Normal& n, int direction, Coord3 p, Nudge nudge) {
  if (const int exact = sign_of(height(t, n, p))) return exact == -direction;
  const int moved = n.y != 0 ? sign_of(n.y) : n.z != 0 ? sign_of(n.z) : direction;
  return moved * static_cast<int>(nudge) == -direction;
}

/// Whether p lies on the triangle, its edges and corners included.  One that has
/// no area has no points: its edges belong to others.
constexpr bool touches(const Corners& t, const Normal& n, Coord3 p) {
  if (n.x == 0 && n.y == 0 && n.z == 0) return false;
  if (height(t, n, p) != 0) return false;
  // Seen along an axis that the plane does not contain, turned so that it is x.
  const auto turned = [&](Coord3 c) {
    return n.x != 0 ? c : n.y != 0 ? Coord3{c.y, c.z, c.x} : Coord3{c.z, c.x, c.y};
  };
  const Coord3 a = turned(t[0]), b = turned(t[1]), c = turned(t[2]), q = turned(p);
  const int ab = side(a, b, q), bc = side(b, c, q), ca = side(c, a, q);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

}  // namespace certet::exact
