#pragma once
/// \file
/// Where rays leave a solid of which signs alone are known.

#include <span>

#include "certet/domain.hpp"
#include "curve.hpp"

namespace certet::features {

/// A line through a surface, from within.
struct Ray {
  Vector origin;     ///< about on the surface
  Vector direction;  ///< outward, of length 1
  double reach;      ///< steps, before and behind the origin
};

struct Hit {
  bool found = false;  ///< it begins inside and ends outside
  Vector place{};      ///< the last whole step inside, or one on the surface
};

/// All of them side by side, so that a domain is asked of many positions at once.  Ends are looked for
/// farther and farther from the origin, until one is inside and the other outside: where the solid is
/// thin or there are several surfaces, that is about the nearest one.
void cast(const Domain& domain, std::span<const Ray> rays, std::span<Hit> hits);
Hit cast(const Domain& domain, const Ray& ray);

}  // namespace certet::features
