#pragma once
/// \file
/// Measuring tetrahedra in exact lattice coordinates.

#include <array>
#include <cstdint>
#include <span>

#include "certet/lattice/coord3.hpp"
#include "certet/quality.hpp"
#include "measurement.hpp"
#include "shape_counter.hpp"

namespace certet::core {

/// Measures every shape once for all its copies.  Every tetrahedron is looked at: those
/// whose edges are the same integer vectors are copies of each other, and cells of a run
/// (`CellRuns`) are.
class LatticeMeasurement {
 public:
  /// All points that tetrahedra will be given of, in steps.
  /// \throws Error `bad_input` if one is beyond `coordinate_limit`.
  explicit LatticeMeasurement(std::span<const Coord3> points);

  /// The tetrahedra with these corners; six times their volumes, in steps cubed, go to
  /// `six_volumes`, which is as long.  \throws Error `bad_input`, as `measure_lattice`.
  void add(std::span<const std::array<Coord3, 4>> tets, std::span<std::int64_t> six_volumes) {
    add_copies(tets, 1, six_volumes);
  }
  /// The same of so many translates of each.
  void add_copies(std::span<const std::array<Coord3, 4>> tets, std::uint64_t copies,
                  std::span<std::int64_t> six_volumes);
  [[nodiscard]] Quality result();

 private:
  void measure(const MeasuredShape& shape, std::uint64_t copies);
  void flush();

  ShapeCounter shapes_;
  Measurement measurement_{Histogram::counted};
  WideSum six_volumes_;
  std::size_t count_ = 0;  ///< of shapes in the block
  TetBlock block_;
  Copies copies_{};
  std::array<std::int64_t, lanes> exact_{};  ///< determinants
};

}  // namespace certet::core
