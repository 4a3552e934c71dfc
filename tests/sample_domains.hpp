#pragma once
/// \file
/// Shapes that several tests mesh, in lattice coordinates.

#include <cmath>
#include <cstdint>

#include "certet/domain.hpp"

namespace certet::test {

/// A domain given by the sign of one position (in steps).
template <class SignAt>
class PointwiseDomain : public Domain {
 public:
  explicit PointwiseDomain(SignAt sign_at) : sign_at_(std::move(sign_at)) {}

  void row(Coord3 first, std::span<Sign> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = sign_at_(steps * (first + 2 * Coord3{static_cast<int>(i), 0, 0}));
  }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = sign_at_(positions[i]);
  }

 private:
  SignAt sign_at_;
};

/// A ball around the origin, its radius in lattice units.
inline auto ball(double radius) {
  return PointwiseDomain([radius](Coord3 p) {
    const double x = double{1} * p.x / steps;
    const double y = double{1} * p.y / steps;
    const double z = double{1} * p.z / steps;
    return sign_of_level(x * x + y * y + z * z - radius * radius);
  });
}

/// A torus around the z axis; radii in lattice units.
inline auto torus(double major, double minor) {
  return PointwiseDomain([major, minor](Coord3 p) {
    const double x = double{1} * p.x / steps;
    const double y = double{1} * p.y / steps;
    const double z = double{1} * p.z / steps;
    const double q = std::sqrt(x * x + y * y) - major;
    return sign_of_level(q * q + z * z - minor * minor);
  });
}

/// The finaliser of a 64-bit hash: every bit of the input moves every bit of
/// the output.
constexpr std::uint64_t mix(std::uint64_t h) {
  h ^= h >> 31;
  h *= 0x7fb5d329728ea185;
  h ^= h >> 27;
  h *= 0x81dadef4bc2dd44d;
  return h ^ h >> 33;
}

/// White noise: every position has a random sign, and a few lie on the surface.
inline auto noise(std::uint64_t seed) {
  return PointwiseDomain([seed](Coord3 p) {
    std::uint64_t h = mix(seed + static_cast<std::uint32_t>(p.x));
    h = mix(h ^ static_cast<std::uint32_t>(p.y));
    h = mix(h ^ static_cast<std::uint32_t>(p.z));
    return h % 16 == 0 ? Sign::on_surface : h % 2 == 0 ? Sign::plus : Sign::minus;
  });
}

}  // namespace certet::test
