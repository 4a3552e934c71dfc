#pragma once
/// \file
/// Which moves of a vertex the limits of the angles allow, decided in integers.

#include <algorithm>
#include <cstdlib>

#include "certet/lattice/well_shaped.hpp"
#include "certet/method.hpp"
#include "zone.hpp"

namespace certet::features {

/// Those of a method, in degrees, rounded so that they are narrower.
inline AngleLimits limits_of(Method method) {
  // 9.27 and 161.46 degrees.
  if (method == Method::embedding) return {{375, 10}, {889, 100}};
  // 11.18 and 157.13 degrees: `KeyAngles` of the certificate.
  if (method == Method::key) return {{179, 7}, {73, 13}};
  return {least_angle, greatest_angle};
}

class Guard {
 public:
  explicit Guard(const Zone& zone) : zone_(zone) {}

  /// Whether all tetrahedra around a vertex keep the limits once it is somewhere else.
  [[nodiscard]] bool allows(Number v, Coord3 place, const AngleLimits& limits) const {
    return std::ranges::all_of(zone_.around(v), [&](StarTet at) {
      TetCorners corners = corners_of(at.tet());
      corners[at.corner()] = place;
      return is_narrow(corners) && keeps_limits(corners, limits);
    });
  }

  [[nodiscard]] TetCorners corners_of(std::uint64_t tet) const {
    const auto& [a, b, c, d] = zone_.tet(tet);
    return {zone_.place(a), zone_.place(b), zone_.place(c), zone_.place(d)};
  }

 private:
  /// As `keeps_limits` wants it.
  static bool is_narrow(const TetCorners& p) {
    constexpr std::int64_t width = 1 << 19;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        for (const std::int64_t by :
             {std::int64_t{p[i].x} - p[j].x, std::int64_t{p[i].y} - p[j].y, std::int64_t{p[i].z} - p[j].z})
          if (std::abs(by) >= width) return false;
    return true;
  }

  const Zone& zone_;
};

}  // namespace certet::features
