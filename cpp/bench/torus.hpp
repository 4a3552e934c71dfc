#pragma once
/// \file
/// The shape of the benchmarks: a torus, R = 1 and r = 0.4.

#include <cmath>
#include <cstdint>

#include "certet/domain.hpp"
#include "certet/stuffing.hpp"

namespace certet::bench {

/// The torus in a lattice whose long edge is `size`.
class Torus : public Domain {
 public:
  explicit Torus(double size) : size_(size), unit_(size / (2.0 * steps)) {}

  void row(Coord3 first, std::span<Sign> out) const override {
    const double y = unit_ * steps * first.y;
    const double z = unit_ * steps * first.z;
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = sign_of_level(level(unit_ * steps * (first.x + 2 * static_cast<int>(i)), y, z));
  }

  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i) {
      const Coord3 p = positions[i];
      out[i] = sign_of_level(level(unit_ * p.x, unit_ * p.y, unit_ * p.z));
    }
  }

  /// The smallest lattice around the torus.
  [[nodiscard]] Lattice lattice() const {
    const int wide = static_cast<int>(std::ceil(1.4 / size_)) + 2;
    const int high = static_cast<int>(std::ceil(0.4 / size_)) + 2;
    return {{-2 * wide, -2 * wide, -2 * high}, {2 * wide, 2 * wide, 2 * high}};
  }

 private:
  static double level(double x, double y, double z) {
    const double q = std::sqrt(x * x + y * y) - 1;
    return q * q + z * z - 0.16;
  }

  double size_;
  double unit_;
};

/// The long edge at which the torus has about `tets` tetrahedra: twelve fill
/// a cube of the long edge.
inline double size_for(double tets) {
  constexpr double volume = 3.15827340834859;  // 2 pi^2 R r^2
  return std::cbrt(12 * volume / tets);
}

}  // namespace certet::bench
