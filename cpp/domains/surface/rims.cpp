#include "rims.hpp"

#include <algorithm>
#include <cmath>

#include "arc.hpp"
#include "vectors.hpp"

namespace certet {
namespace {

using exact::Nudge;

constexpr double four_pi = 12.56637061435917295385;

/// A node is far if it is so many times its radius away.
constexpr double far_radii = 2;

/// A point of a rim, as another sees it.
struct Seen {
  Coord3 point;
  std::int64_t y, z;
  double above;  ///< its distance, less how far ahead it is
};

Seen seen(Coord3 point, Coord3 from, Nudge nudge) {
  const double x = static_cast<double>(exact::gap(from.x, point.x));
  Seen result{point, exact::gap(from.y, point.y), exact::gap(from.z, point.z), 0};
  const double y = static_cast<double>(result.y), z = static_cast<double>(result.z);
  const double aside = y * y + z * z, distance = std::sqrt(x * x + aside);
  result.above = x > 0 ? aside / (distance + x) : distance - x;
  // On the ray: it is where the other was not moved to, and all that counts is where.
  if (aside == 0 && x > 0) result.y = -static_cast<int>(nudge);
  return result;
}

/// Whether the point that sees them is between two points that it sees one before or
/// behind the other.
bool is_between(const Seen& a, const Seen& b, Coord3 from) {
  const std::int64_t ax = exact::gap(from.x, a.point.x), bx = exact::gap(from.x, b.point.x);
  if (exact::Wide{ax} * b.y != exact::Wide{bx} * a.y || exact::Wide{ax} * b.z != exact::Wide{bx} * a.z)
    return false;
  return exact::Wide{ax} * bx <= 0 && exact::Wide{a.y} * b.y <= 0 && exact::Wide{a.z} * b.z <= 0;
}

/// The solid angle between an edge and the far end of the x axis, as a part of the
/// sphere: by stereographic projection it is an angle in the plane.  Half a turn from
/// either side is told apart exactly, as `exact::passing` does.
double beside(const Seen& a, const Seen& b, Coord3 from, Nudge nudge) {
  const exact::Wide turn = exact::Wide{a.y} * b.z - exact::Wide{a.z} * b.y;
  const double along = a.above * b.above + static_cast<double>(a.y) * static_cast<double>(b.y) +
                       static_cast<double>(a.z) * static_cast<double>(b.z);
  if (turn != 0) return -angle_in_turns(static_cast<double>(turn), along);
  if (is_between(a, b, from)) return NAN;
  return along < 0 ? -0.5 * exact::side(a.point, b.point, from, nudge) : 0;
}

/// Whether the ray from p along x meets the box.
bool is_ahead(const IntegerBox& box, Coord3 p) {
  return box.high.x >= p.x && box.low.y <= p.y && p.y <= box.high.y && box.low.z <= p.z &&
         p.z <= box.high.z;
}

/// Whether such a ray from some point of another box may.
bool is_ahead(const IntegerBox& box, const IntegerBox& from) {
  return box.high.x >= from.low.x && box.low.y <= from.high.y && from.low.y <= box.high.y &&
         box.low.z <= from.high.z && from.low.z <= box.high.z;
}

Point3 gap(const Point3& to, Coord3 from) {
  return {to[0] - static_cast<double>(from.x), to[1] - static_cast<double>(from.y),
          to[2] - static_cast<double>(from.z)};
}

double distance_to(const IntegerBox& box, Coord3 p) {
  const auto outside = [](std::int32_t low, std::int32_t high, std::int32_t at) {
    return static_cast<double>(
        std::max({exact::gap(at, low), exact::gap(high, at), std::int64_t{0}}));
  };
  const Point3 away{outside(box.low.x, box.high.x, p.x), outside(box.low.y, box.high.y, p.y),
                    outside(box.low.z, box.high.z, p.z)};
  return std::sqrt(dot(away, away));
}

}  // namespace

double Rims::rest(Coord3 p, Nudge nudge) const {
  double sum = 0;
  for (std::uint32_t n = 0; n < tree_.nodes.size();) {
    const RimNode& node = tree_.nodes[n];
    const Point3 away = gap(node.centre, p);
    const bool far = dot(away, away) > far_radii * far_radii * node.radius * node.radius &&
                     !is_ahead(node.box, p);
    if (!far && !tree_.is_leaf(n)) {
      ++n;
      continue;
    }
    if (far) sum += node.area.solid_angle(away) / four_pi;
    const std::uint32_t step = far ? node.last - node.first : 1;
    Seen a = seen(tree_.chain[node.first], p, nudge);
    for (std::uint32_t at = node.first; at < node.last; at += step) {
      const Seen b = seen(tree_.chain[at + step], p, nudge);
      sum += beside(a, b, p, nudge);
      a = b;
    }
    n = node.next;
  }
  return sum;
}

double Rims::variation(Coord3 centre, double radius, double enough) const {
  double sum = 0;
  for (std::uint32_t n = 0; n < tree_.nodes.size();) {
    const RimNode& node = tree_.nodes[n];
    const double away = distance_to(node.box, centre) - radius;
    if (away < 4 * node.radius && !tree_.is_leaf(n)) {
      ++n;
      continue;
    }
    const double as_one = node.chord + 2 * node.area.area() / away;
    sum += away > 0 ? radius * std::min(node.length, as_one) / (away * away) / four_pi : INFINITY;
    if (sum > enough) return INFINITY;
    n = node.next;
  }
  return sum;
}

bool Rims::may_be_ahead(const IntegerBox& box) const {
  for (std::uint32_t n = 0; n < tree_.nodes.size();) {
    const RimNode& node = tree_.nodes[n];
    if (!is_ahead(node.box, box)) {
      n = node.next;
      continue;
    }
    if (tree_.is_leaf(n))
      for (std::uint32_t at = node.first; at < node.last; ++at) {
        IntegerBox edge{tree_.chain[at], tree_.chain[at]};
        edge.add({tree_.chain[at + 1], tree_.chain[at + 1]});
        if (is_ahead(edge, box)) return true;
      }
    ++n;
  }
  return false;
}

std::uint64_t Rims::bytes() const {
  return tree_.chain.size() * sizeof(tree_.chain[0]) + tree_.nodes.size() * sizeof(tree_.nodes[0]);
}

}  // namespace certet
