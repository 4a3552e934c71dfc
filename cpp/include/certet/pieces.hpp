#pragma once
/// \file
/// The pieces of a mesh, where its surface is no manifold, and which pieces to keep.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "certet/frame.hpp"

namespace certet {

/// How many pieces some tetrahedra make.
struct PieceCount {
  std::uint64_t by_faces = 0;     ///< what is joined by faces that two tetrahedra share
  std::uint64_t by_vertices = 0;  ///< what is joined by points; never more of these
  friend bool operator==(const PieceCount&, const PieceCount&) = default;
};

/// How many pieces a shape has: where two parts touch at an edge or a corner, its mesh may
/// join them or not.
struct PieceBounds {
  std::uint64_t least = 0, most = 0;
  friend bool operator==(const PieceBounds&, const PieceBounds&) = default;
};

/// Whether the mesh may be one of such a shape.
inline bool may_be(const PieceBounds& shape, const PieceCount& mesh) {
  return shape.least <= mesh.by_faces && mesh.by_vertices <= shape.most;
}

/// The pieces of one label's tetrahedra; those of other labels join nothing.
struct RegionPieces {
  std::int32_t label = 0;
  PieceCount pieces;
  friend bool operator==(const RegionPieces&, const RegionPieces&) = default;
};

/// Where the boundary, the faces in one tetrahedron only, is no manifold.
struct SurfaceFaults {
  std::uint64_t edges = 0;     ///< in more than two faces of the boundary
  std::uint64_t vertices = 0;  ///< around which its faces are not one closed fan; the ends of
                               ///< such edges too
  /// Where the first few are, by numbers of points: the middle of an edge, a vertex.
  std::vector<Point3> edge_places, vertex_places;
  friend bool operator==(const SurfaceFaults&, const SurfaceFaults&) = default;
};

/// No more places than these are told.
inline constexpr std::size_t most_places = 8;

struct Pieces {
  PieceCount whole;
  std::uint64_t largest = 0;  ///< tetrahedra of the largest piece by faces
  std::vector<RegionPieces> regions;  ///< by growing labels, where they were counted
  SurfaceFaults surface;
  friend bool operator==(const Pieces&, const Pieces&) = default;
};

/// Which pieces by faces are to stay: those of the whole mesh, whatever their labels are, for
/// to drop a piece of one label within others would leave a hole.
struct KeepLargest {
  std::uint64_t count = 1;  ///< so many of the most tetrahedra, of equals those that begin first
};
/// Those whose lattice points inside reach from one end of all those to the other along an
/// axis of the lattice, but for a long edge at either.
struct KeepPercolating {
  std::size_t axis = 0;  ///< 0, 1 or 2
};
using KeepRule = std::variant<KeepLargest, KeepPercolating>;

/// A rule in words: `largest`, a number of pieces, or `percolating:x`, y or z; none if it is
/// none of these.
std::optional<KeepRule> keep_rule(std::string_view text);

}  // namespace certet
