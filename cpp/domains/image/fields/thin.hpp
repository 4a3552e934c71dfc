#pragma once
/// \file
/// Which voxels are so thin that smoothing may lose them.

#include <array>
#include <cstdint>
#include <vector>

#include "fields/field_tile.hpp"
#include "fields/label_window.hpp"

namespace certet::fields {

/// For each voxel of a window which of the eight blocks of 2 x 2 x 2 voxels around it
/// have its label throughout; a voxel without such a block is thin.  Not filled in the
/// outermost voxels.
std::vector<std::uint8_t> whole_blocks(const LabelWindow& window);

/// Flags for each node of a tile.
using NodeFlags = std::array<bool, std::size_t{tile_nodes} * tile_nodes * tile_nodes>;

/// Whether one of the 27 voxels round a node is thin.  The window's halo is at least 2.
/// \returns whether there is one.
bool find_thin(const LabelWindow& window, const std::vector<std::uint8_t>& whole,
               NodeFlags& flags);

enum class Slender : std::uint8_t {
  no,
  row,   ///< along some axis it is one of one or two of its label in a row
  part,  ///< so are its face neighbours of that label beside the row: a part of a sheet or a
         ///< wire, which does not stand out of something thick
  thin_part,  ///< and it is thin
};

/// How slender the voxels of nodes are.
using Slenderness = std::array<Slender, std::size_t{tile_nodes} * tile_nodes * tile_nodes>;

void find_slender(const LabelWindow& window, const std::vector<std::uint8_t>& whole,
                  Slenderness& slender);

/// Whether a voxel may be lost, or lose a neighbour, where no point of the lattice is at
/// its centre: it is thin, or has no whole block in common with a face neighbour of its
/// label, or its whole blocks do not hang together by faces.
void find_at_risk(const LabelWindow& window, const std::vector<std::uint8_t>& whole,
                  NodeFlags& flags);

}  // namespace certet::fields
