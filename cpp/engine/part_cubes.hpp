#pragma once
/// \file
/// Samples of a shape whose even points alone tell what hangs together.

#include <array>
#include <cstdint>

#include "certet/context.hpp"
#include "sign_planes.hpp"
#include "window.hpp"

namespace certet::core {

/// The corners of 64 cubes, a bit for each: number n is at (n & 1, n >> 1 & 1, n >> 2).
using CubeCorners = std::array<std::uint64_t, 8>;

/// Which of the cubes have their plus corners in two or more groups, joined by edges of
/// the cube: `CubeParted` of the certificate.
std::uint64_t parted_cubes(const CubeCorners& plus);

/// Turns the odd points of a window to minus whose eight even neighbours, a cube's
/// corners, are plus in two or more groups: they would join what no edge between even
/// points does.  `planes` hold the window and the layer behind it, if there is one.
void part_cubes(SignPlanes& planes, Window window, Context& context);

}  // namespace certet::core
