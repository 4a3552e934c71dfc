#pragma once
/// \file
/// With which weights the voxels along an axis are smoothed.

#include <cstdint>
#include <vector>

namespace certet::fields {

/// Weights of 2 radius + 1 voxels, in 65536ths, each a whole number of 4096ths; all
/// together 1.  None: a voxel stays as it is.
struct Taps {
  std::vector<std::uint16_t> weights;

  [[nodiscard]] int radius() const { return static_cast<int>(weights.size() / 2); }
  /// In squared voxels.
  [[nodiscard]] double variance() const;
};

/// (1 4 6 4 1)/16, of standard deviation 1.
Taps binomial_taps();

/// (3 10 3)/16, for thin parts.
Taps thin_taps();

/// Of a Gaussian with a standard deviation of so many voxels, cut off at 2.5 of them.
Taps gaussian_taps(double sigma);

/// The widest that `gaussian_taps` gives: a tile's surroundings, and the labels in
/// them, are bounded by it.
inline constexpr double greatest_sigma = 4;
inline constexpr int greatest_radius = 10;

/// The one with the smaller variance.
Taps narrower(const Taps& one, const Taps& other);

}  // namespace certet::fields
