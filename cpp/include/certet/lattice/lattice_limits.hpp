#pragma once
/// \file
/// How large a lattice may be, in cells and in the world: what every maker of a
/// frame and a lattice checks.

#include <cstdint>

#include "certet/lattice/structured_tet.hpp"

namespace certet {

/// The cells along an axis that fit the coordinate range, if the lattice is
/// centred around 0.
inline constexpr std::int32_t cells_limit = anchor_limit - 2;

/// The long edges between which no point, volume or angle in world coordinates
/// leaves the range of floating-point numbers, of those of 32 bits in .stl files too.
inline constexpr double least_size = 1e-30, greatest_size = 1e30;

/// A number of cells computed in floating point, as a whole number.
/// \throws Error `too_large` beyond cells_limit, and for NaN
std::int32_t checked_cells(double cells);

/// A long edge in world units.
/// \throws Error `bad_option` unless it is positive and finite, `too_large` if it
/// is not from least_size to greatest_size
double checked_size(double size);

/// Cells around a solid.
/// \throws Error `bad_option` if there is none: the outermost points are outside
std::int32_t checked_margin(std::int32_t margin);

}  // namespace certet
