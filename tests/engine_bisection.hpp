#pragma once
/// \file
/// The engine keeps its bisection to itself, so it is watched through a mesh:
/// one - vertex in the middle of + vertices, and on one of its edges the sign
/// under test.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>

#include "certet/stuffing.hpp"
#include "domains.hpp"

namespace engine_bisection {

using certet::Coord3;
using certet::Sign;

/// The sign at a number of steps from the + end of an edge.
using SignOnEdge = std::function<Sign(std::int64_t)>;

inline constexpr Coord3 minus_end{0, 0, 0};
inline constexpr certet::Lattice lattice{{-6, -6, -6}, {7, 7, 7}};

/// All + but for one vertex; its edges are cut in the middle, but for one.
inline domains::Positional one_edge(Coord3 plus_end, const SignOnEdge& sign) {
  return domains::Positional([=](Coord3 p) {
    const auto [a, b, t] = domains::edge_of(p);
    if (t == 0) return a == minus_end ? Sign::minus : Sign::plus;
    const std::int32_t from_plus = b == minus_end ? t : certet::steps - t;
    if ((a == plus_end && b == minus_end) || (b == plus_end && a == minus_end))
      return sign(from_plus);
    return from_plus <= certet::steps / 2 ? Sign::plus : Sign::minus;
  });
}

/// The vertex of the mesh that is nearest to the - end lies at the cut, be it a
/// cut or a warped end.
inline std::int64_t bisect(int direction, const SignOnEdge& sign) {
  const Coord3 towards = certet::direction_offset[static_cast<std::size_t>(direction)];
  const Coord3 plus_end = minus_end - towards;
  const domains::Positional domain = one_edge(plus_end, sign);
  certet::Context context;
  context.threads = 1;  // the mesh is tiny
  const certet::Mesh mesh =
      certet::stuff(domain, lattice, {}, certet::Method::embedding,
                    context);
  std::int64_t last = -1;
  for (const Coord3 point : mesh.points) {
    const Coord3 from_plus = point - certet::steps * plus_end;
    const std::int32_t t = std::abs(from_plus.x + from_plus.y + from_plus.z) /
                           std::abs(towards.x + towards.y + towards.z);
    if (t < certet::steps && from_plus == t * towards) last = std::max<std::int64_t>(last, t);
  }
  return last;
}

}  // namespace engine_bisection
