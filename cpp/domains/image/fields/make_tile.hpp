#pragma once
/// \file
/// From the labels around a tile to its fields.

#include <memory>

#include "fields/field_tile.hpp"
#include "fields/label_window.hpp"
#include "fields/rules.hpp"

namespace certet::fields {

/// How many voxels around a tile its fields depend on.
int halo_of(const Rules& rules);

/// The smoothed indicators, without constants and not held yet.  nullptr where the
/// window has one label.
std::unique_ptr<Tile> make_tile(const LabelWindow& window, const Rules& rules);

}  // namespace certet::fields
