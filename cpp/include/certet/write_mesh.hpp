#pragma once
/// \file
/// From a counted mesh to a file, slab by slab, measuring it on the way.

#include <cstdint>
#include <span>
#include <vector>

#include "certet/context.hpp"
#include "certet/formats.hpp"
#include "certet/frame.hpp"
#include "certet/placed_quality.hpp"
#include "certet/stuffing.hpp"
#include "certet/survey.hpp"

namespace certet {

/// A mesh cut into slabs of whole layers.
struct Slabs {
  std::vector<std::int32_t> bounds;  ///< slab s is the layers [bounds[s], bounds[s+1])
  std::uint64_t points = 0;          ///< of the largest slab, with those of the layer behind
  std::uint64_t tets = 0;            ///< of the largest slab
  std::uint64_t bytes = 0;           ///< that writing the mesh this way needs, without middle nodes
};

/// Slabs of as many layers as can be written with `max_bytes`; of at least one,
/// so that `bytes` may turn out greater.
Slabs cut_slabs(const Stuffing& stuffing, std::uint64_t max_bytes);

/// What is known of a mesh that has been written.
struct WrittenMesh : PlacedQuality {
  std::uint64_t checksum = 0;       ///< of the mesh in lattice coordinates
  std::uint64_t file_checksum = 0;  ///< that of a `FileMesh` with what was written
  std::vector<Region> regions;      ///< by growing labels, without names; none is empty
  std::vector<RegionPieces> region_pieces;  ///< if they were asked for
  /// Of all threads together; they overlap.
  double emit_seconds = 0, measure_seconds = 0, write_seconds = 0;
};

/// Writes all points, then all tetrahedra, with labels if the domain has any.
/// `known` are the materials that a survey of this mesh found; the domain is asked if
/// there are none.  While one slab is written, the next is made.
/// With `label_pieces`, counts the pieces of each of several labels on the way, which takes
/// about as long as measuring does.
/// With `middles`, those of the mesh, which `writer` was told of too, writes them behind the points.
/// With `moved`, its points once they have moved, writes these in the place of its own.
/// Of a mesh that several ranks make together each writes its own layers, and all get what is known of
/// the whole; the pieces of labels are not counted then.
/// Does not finish the file, so that the caller may ask `standing_of` the mesh first.  What
/// is written and returned (but for the seconds) does not depend on slabs and
/// threads.
/// \throws Error `write_failed`, `cancelled`, `too_large` (out of memory), and as
/// `checked_size` for the size of the frame.
WrittenMesh write_mesh(const Stuffing& stuffing, const Frame& frame, const Slabs& slabs,
                       MeshWriter& writer, Context& context, const MaterialRuns& known = {},
                       bool label_pieces = false, const MiddleNodes* middles = nullptr,
                       std::span<const Coord3> moved = {});

}  // namespace certet
