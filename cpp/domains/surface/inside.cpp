#include "inside.hpp"

#include <cmath>
#include <string>

#include "certet/error.hpp"
#include "edges.hpp"
#include "holes.hpp"

namespace certet {
namespace {

/// What is taken for one half; far more than rounding, far less than what is seen.
constexpr double about = 1e-9;

std::vector<RimLoop> rims_of(const TriangleSurface& surface, const std::vector<Coord3>& points) {
  std::vector<RimLoop> rims;
  for (const HoleLoop& loop : rim_loops(surface)) {
    RimLoop& rim = rims.emplace_back();
    rim.reserve(loop.size() + 1);
    for (const std::uint32_t p : loop) rim.push_back(points[p]);
    rim.push_back(rim.front());
  }
  return rims;
}

IntegerBox box_around(const TriangleSurface& surface, const std::vector<Coord3>& points) {
  const Coord3 any = points[surface.triangles[0][0]];
  IntegerBox box{any, any};
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t p : triangle) box.add({points[p], points[p]});
  return box;
}

bool is_within(const IntegerBox& inner, const IntegerBox& outer) {
  return outer.low.x <= inner.low.x && inner.high.x <= outer.high.x && outer.low.y <= inner.low.y &&
         inner.high.y <= outer.high.y && outer.low.z <= inner.low.z && inner.high.z <= outer.high.z;
}

/// From one corner to the middle.
double half_diagonal(const IntegerBox& box) {
  const double x = static_cast<double>(exact::gap(box.low.x, box.high.x)),
               y = static_cast<double>(exact::gap(box.low.y, box.high.y)),
               z = static_cast<double>(exact::gap(box.low.z, box.high.z));
  return std::sqrt(x * x + y * y + z * z) / 2 + 1;
}

}  // namespace

Rule closed_rule(const TriangleSurface& surface) {
  Rule rule = Rule::winding;
  for (const SurfaceEdge& edge : edges_of(surface)) {
    if (edge.odd())
      throw Error(ErrorCode::bad_input,
                  "'" + surface.name + "' is " + (edge.open() ? "open" : "non-manifold") +
                      ": it does not enclose a solid");
    if (edge.misoriented()) rule = Rule::parity;
  }
  return rule;
}

Rule open_rule(const TriangleSurface& surface) {
  if (is_closed(surface)) return closed_rule(surface);
  for (const SurfaceEdge& edge : edges_of(surface))
    if (edge.misoriented() && !edge.overfull())
      throw Error(ErrorCode::bad_input,
                  "'" + surface.name + "' is open, and its triangles do not agree which side is "
                      "out: what they wind around cannot be told");
  return Rule::half;
}

Inside::Inside(const TriangleSurface& surface, const std::vector<Coord3>& points, Rule rule)
    : rule_(rule), around_(box_around(surface, points)),
      rims_(rule == Rule::half ? rims_of(surface, points) : std::vector<RimLoop>()) {
  if (rule == Rule::half) steady_.emplace(rims_, around_);
}

Sign Inside::at_half(int crossings, Coord3 p, exact::Nudge nudge) const {
  if (!is_within({p, p}, around_)) return Sign::minus;
  if (const std::optional<int> rest = steady_->whole(p))
    return crossings + *rest != 0 ? Sign::plus : Sign::minus;
  const double more = std::fabs(winding(crossings, p, nudge)) - 0.5;
  return sign_of_bits(more > about, std::fabs(more) <= about);
}

Extent Inside::over(const IntegerBox& box, Coord3 middle, int crossings) const {
  if (rule_ != Rule::half)
    return at(crossings, middle, exact::Nudge::forward) == Sign::plus ? Extent::inside
                                                                      : Extent::outside;
  if (!box.meets(around_)) return Extent::outside;
  const double more = std::fabs(winding(crossings, middle, exact::Nudge::forward)) - 0.5;
  const double room = std::fabs(more) - lost_far_away;
  if (room < 0 || rims_.variation(middle, half_diagonal(box), room) > room) return Extent::mixed;
  if (more < 0) return Extent::outside;
  return is_within(box, around_) ? Extent::inside : Extent::mixed;
}

}  // namespace certet
