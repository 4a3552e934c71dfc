#pragma once
/// \file
/// What blocks of measured tetrahedra amount to.

#include <array>
#include <cstdint>

#include "angle_bins.hpp"
#include "certet/quality.hpp"
#include "tet_block.hpp"

namespace certet::core {

/// How many tetrahedra each lane stands for.
using Copies = std::array<std::uint64_t, lanes>;

/// Whether all tetrahedra of a block are positive, in range, and not nearly flat.
bool ordinary(const TetBlock& block);

/// The first of all lanes after folding the upper half onto the lower again and
/// again: always the same order, whatever the machine.
template <class Operation>
double folded(Lanes values, Operation operation) {
  for (std::size_t half = lanes / 2; half > 0; half /= 2)
    for (std::size_t i = 0; i < half; ++i) values[i] = operation(values[i], values[i + half]);
  return values[0];
}

/// Sums up blocks; what is exact and needs no order is kept in `quality_`.
class Measurement {
 public:
  explicit Measurement(Histogram histogram) : wants_histogram_(histogram == Histogram::counted) {}

  /// `block` has been computed; its lanes from `count` on repeat the first.
  /// `positive(lane)` tells whether a tetrahedron is.
  template <class Positive>
  void add(TetBlock& block, std::size_t count, const Copies& copies, const Positive& positive);
  [[nodiscard]] Quality result();

 private:
  void add_ordinary(const TetBlock& block);
  void add_angles(const TetBlock& block, std::size_t lane);
  void add_extremes(const std::array<double, 6>& signed_squared_cotangents);
  void add_careful(const CarefulTet& tet, std::uint64_t copies);
  void count_angles(TetBlock& block, std::size_t count, const Copies& counted);

  Quality quality_;
  bool wants_histogram_;
  const AngleBins& bins_ = angle_bins();
  // One histogram for each pair of faces: neighbouring tetrahedra are alike,
  // and counting in one place again and again would wait for memory.
  std::array<std::array<std::uint64_t, Quality::bins>, 6> histograms_{};
  double greatest_ = -1, least_ = 1;
};

template <class Positive>
void Measurement::add(TetBlock& block, std::size_t count, const Copies& copies,
                      const Positive& positive) {
  for (std::size_t i = 0; i < count; ++i) quality_.tets += copies[i];
  if (ordinary(block)) {
    add_ordinary(block);
    return count_angles(block, count, copies);
  }
  Copies counted{};
  for (std::size_t i = 0; i < count; ++i) {
    if (block.in_range(i))
      quality_.least_face = std::min(quality_.least_face, block.least_face[i]);
    if (!positive(i))
      quality_.nonpositive += copies[i];
    else if (!block.in_range(i))
      add_careful(CarefulTet(block.get(i)), copies[i]);
    else {
      add_angles(block, i);
      counted[i] = copies[i];
    }
  }
  count_angles(block, count, counted);
}

}  // namespace certet::core
