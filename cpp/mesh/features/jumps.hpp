#pragma once
/// \file
/// Edges of a mesh's boundary on whose way the surface of the domain turns sharply.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "seen_surface.hpp"

namespace certet::features {

/// Two faces of a solid that meet along a line.
struct Wedge {
  std::array<Vector, 2> normals;  ///< outward, of length 1
  bool convex;                    ///< the solid is on the inner side of both

  /// A direction in one of the faces, away from where they meet.
  [[nodiscard]] Vector into(std::size_t face) const;
};

/// Where the surface turns between two vertices: at `place` the face of the first ends.
struct Jump {
  std::array<std::uint32_t, 2> ends;  ///< numbers in the surface, growing
  Vector place;
  Wedge wedge;
};

/// Whether an edge may have one.
using MayJump = std::function<bool(std::uint32_t, std::uint32_t)>;

/// All by more than an angle, in degrees, by growing numbers of the ends.
std::vector<Jump> find_jumps(const SeenSurface& surface, const Domain& domain, double angle,
                             const MayJump& may_jump, Context& context);

}  // namespace certet::features
