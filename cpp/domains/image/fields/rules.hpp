#pragma once
/// \file
/// By which rules fields are made.

#include <array>

#include "fields/taps.hpp"

namespace certet::fields {

/// All are meant to be used; each can be left out to see what it is for.
struct Rules {
  std::array<Taps, 3> taps{binomial_taps(), binomial_taps(), binomial_taps()};
  bool slope_treads = true;  ///< stairs with long treads become ramps
  bool narrow_thin = true;   ///< narrower taps around thin voxels
  bool keep_volumes = true;  ///< a constant for each label
  bool correct_by_mesh = true;  ///< which is corrected where the mesh of a small region asks for it
  bool hold = true;          ///< the label of a voxel wins at its centre
  bool hold_slender = true;  ///< by more where sheets and wires are one or two voxels thick
};

}  // namespace certet::fields
