#pragma once
/// \file
/// Which points of a mesh lie where its domain is cut off.

#include <array>
#include <span>

#include "certet/border.hpp"
#include "certet/lattice/coord3.hpp"
#include "certet/method.hpp"

namespace certet::core {

/// The two vertices, in lattice units, whose edge has its middle here (in steps):
/// of a long edge the lower first, of a short one the even one.
std::array<Coord3, 2> ends_of_middle(Coord3 middle);

/// Whether a point of a mesh, in steps, that lies on its surface lies where the
/// domain is cut off by one of the boxes.  A cut in the middle of its edge does
/// if that edge leaves the box.
bool is_on_border(Coord3 point, std::span<const BorderBox> boxes, Cuts cuts);

}  // namespace certet::core
