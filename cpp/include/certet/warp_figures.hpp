#pragma once
/// \file
/// What became of the vertices that the surface passes too close to.

#include <algorithm>
#include <cstdint>

namespace certet {

/// How far cuts were moved along edges of one kind.
struct CutShift {
  std::uint64_t cuts = 0;            ///< those that were moved
  std::int32_t greatest = 0;         ///< steps
  std::uint64_t sum_of_squares = 0;  ///< steps²

  void add(std::int32_t distance) {
    ++cuts;
    greatest = std::max(greatest, distance);
    sum_of_squares += static_cast<std::uint64_t>(std::int64_t{distance} * distance);
  }
  void add(const CutShift& other) {
    cuts += other.cuts;
    greatest = std::max(greatest, other.greatest);
    sum_of_squares += other.sum_of_squares;
  }
  friend bool operator==(const CutShift&, const CutShift&) = default;
};

/// A violated vertex moves onto the surface, perhaps not as far as its cut, or stays;
/// then cuts that are too close to it are moved away from it.
struct WarpFigures {
  std::uint64_t violated = 0, stayed = 0, shortened = 0;  ///< vertices
  CutShift long_edges, short_edges;
  CutShift missed;  ///< by how much shortened moves, all along long edges, miss the surface

  void add(const WarpFigures& other) {
    violated += other.violated;
    stayed += other.stayed;
    shortened += other.shortened;
    missed.add(other.missed);
    long_edges.add(other.long_edges);
    short_edges.add(other.short_edges);
  }
  friend bool operator==(const WarpFigures&, const WarpFigures&) = default;
};

/// The same of all cuts, as lengths, or of all shortened moves.
struct ShiftLengths {
  std::uint64_t cuts = 0;
  double greatest = 0, rms = 0;  ///< rms: of those that were moved
};

/// In edges: each in lengths of its own.
ShiftLengths shift_in_edges(const WarpFigures& figures);
/// In world units; `size` is the long edge.
ShiftLengths shift_in_world(const WarpFigures& figures, double size);
/// Of shortened moves, whose edges are of this length: 1, or the size in world units.
ShiftLengths missed_by(const WarpFigures& figures, double long_edge);

}  // namespace certet
