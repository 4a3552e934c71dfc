#pragma once
/// \file
/// The volume of a trial's shape, without its mesh.

#include <array>

#include "certet/lattice/coord3.hpp"
#include "certet/lattice/direction.hpp"
#include "trial.hpp"

namespace soak {

/// A position, and one away from it along each of the lattice's directions.
using Star = std::array<certet::Coord3, 1 + certet::direction_count>;

/// The star around a position with arms of `reach` steps, of which `certet::steps`
/// make an edge.
Star star(certet::Coord3 position, std::int32_t reach);

/// Volumes of the shape by Monte Carlo, in lattice units cubed.  What has the surface
/// within half an edge, along any direction of the lattice, is near it.
struct VolumeEstimate {
  double inside, deep;  ///< all of it; what is not near the surface
  double near;          ///< what is near it on either side
  double deviation;     ///< of `inside`
};

VolumeEstimate estimate_volume(const Trial& trial);

}  // namespace soak
