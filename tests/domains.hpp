#pragma once
/// \file
/// Domains to try the engine on: smooth, thin, noisy, and utterly random.

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "certet/domain.hpp"
#include "certet/stuffing.hpp"
#include "seed.hpp"

namespace domains {

using certet::Coord3;
using certet::Sign;

/// A domain given by its sign at any position, in steps.
class Positional : public certet::Domain {
 public:
  using SignAt = std::function<Sign(Coord3)>;
  explicit Positional(SignAt sign_at) : sign_at_(std::move(sign_at)) {}

  [[nodiscard]] Sign sign_at(Coord3 position) const { return sign_at_(position); }

  void row(Coord3 first, std::span<Sign> out) const override {
    for (Sign& sign : out) {
      sign = sign_at_(certet::steps * first);
      first.x += 2;
    }
  }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = sign_at_(positions[i]);
  }

 private:
  SignAt sign_at_;
};

/// One whose even points alone tell what hangs together.
class Parted final : public Positional {
 public:
  using Positional::Positional;
  [[nodiscard]] bool even_points_tell_pieces() const override { return true; }
};

/// The signs of another domain, and nothing else that is known of it.
class SignsAlone : public certet::Domain {
 public:
  explicit SignsAlone(const certet::Domain& domain) : domain_(domain) {}
  void row(Coord3 first, std::span<Sign> out) const override { domain_.row(first, out); }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    domain_.at(positions, out);
  }

 private:
  const certet::Domain& domain_;
};

/// A domain that is negative inside, of lattice coordinates.
using Level = std::function<double(double x, double y, double z)>;

inline Positional of_level(Level level) {
  return Positional([level = std::move(level)](Coord3 p) {
    constexpr double unit = certet::steps;
    return certet::sign_of_level(level(p.x / unit, p.y / unit, p.z / unit));
  });
}

inline Level sphere(double cx, double cy, double cz, double r) {
  return [=](double x, double y, double z) {
    return (x - cx) * (x - cx) + (y - cy) * (y - cy) + (z - cz) * (z - cz) - r * r;
  };
}

/// Axis along z.
inline Level torus(double cx, double cy, double cz, double major, double minor) {
  return [=](double x, double y, double z) {
    const double tube = std::sqrt((x - cx) * (x - cx) + (y - cy) * (y - cy)) - major;
    return tube * tube + (z - cz) * (z - cz) - minor * minor;
  };
}

/// The space between two parallel planes, `thickness` apart.
inline Level slab(double nx, double ny, double nz, double offset, double thickness) {
  const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
  return [=](double x, double y, double z) {
    return std::abs((nx * x + ny * y + nz * z) / length - offset) - thickness / 2;
  };
}

/// A surface of many handles, of the given period.
inline Level gyroid(double period, double thickness) {
  const double k = 2 * 3.14159265358979 / period;
  return [=](double x, double y, double z) {
    return std::abs(std::sin(k * x) * std::cos(k * y) + std::sin(k * y) * std::cos(k * z) +
                    std::sin(k * z) * std::cos(k * x)) -
           thickness;
  };
}

/// A box whose faces pass through lattice points, which lie on the surface.
inline Level box(double low, double high) {
  return [=](double x, double y, double z) {
    return std::max({low - x, x - high, low - y, y - high, low - z, z - high});
  };
}

/// Noise of every frequency: each position has its own random sign.  `zeros` in
/// 256ths say how often it is 0.
inline Positional noise(std::uint64_t seed, unsigned zeros) {
  return Positional([=](Coord3 p) {
    const std::uint64_t h = mixed(seed, p.x, p.y, p.z);
    if (h % 256 < zeros) return Sign::on_surface;
    return h >> 32 & 1 ? Sign::plus : Sign::minus;
  });
}

/// A lattice edge and how far along it a position lies.
struct EdgePosition {
  Coord3 even_or_low, other;  ///< the ends, in lattice units
  std::int32_t t;             ///< steps from the first
};

/// The edge on which a position lies; a lattice point lies at 0 of some edge.
inline EdgePosition edge_of(Coord3 p) {
  const auto down = [](std::int32_t c) { return c >> certet::step_bits; };
  const Coord3 low{down(p.x), down(p.y), down(p.z)};
  const Coord3 rest = p - certet::steps * low;
  const int moving = (rest.x != 0) + (rest.y != 0) + (rest.z != 0);
  const auto parity = [](std::int32_t c) { return c & 1; };
  if (moving == 0 && parity(low.x) == parity(low.y) && parity(low.y) == parity(low.z))
    return {low, low + Coord3{2, 0, 0}, 0};
  if (moving <= 1) {
    // A long edge runs along the axis that moves, or whose parity stands alone.
    const auto along = [&](std::int32_t Coord3::*axis, std::int32_t fixed) {
      Coord3 first = low;
      first.*axis -= parity(low.*axis ^ fixed);
      Coord3 second = first;
      second.*axis += 2;
      return EdgePosition{first, second, (p.*axis - certet::steps * first.*axis) / 2};
    };
    if (rest.x != 0 || (moving == 0 && parity(low.y) == parity(low.z)))
      return along(&Coord3::x, low.y);
    if (rest.y != 0 || (moving == 0 && parity(low.x) == parity(low.z)))
      return along(&Coord3::y, low.x);
    return along(&Coord3::z, low.x);
  }
  const auto even = [&](std::int32_t c) { return c + parity(c); };
  const auto odd = [&](std::int32_t c) { return c + 1 - parity(c); };
  const Coord3 from{even(low.x), even(low.y), even(low.z)};
  return {from, {odd(low.x), odd(low.y), odd(low.z)}, std::abs(p.x - certet::steps * from.x)};
}

/// Lattice points have random signs, and each edge is cut where `cuts` say: one
/// of them by chance, in steps from the + end.
inline Positional random_cuts(std::uint64_t seed, unsigned zeros,
                              std::vector<std::int32_t> cuts) {
  const auto corner = [=](Coord3 v) {
    const std::uint64_t h = mixed(seed, v.x, v.y, v.z);
    if (h % 256 < zeros) return Sign::on_surface;
    return h >> 32 & 1 ? Sign::plus : Sign::minus;
  };
  return Positional([=, cuts = std::move(cuts)](Coord3 p) {
    const auto [a, b, t] = edge_of(p);
    if (t == 0) return corner(a);
    const bool from_a = corner(a) == Sign::plus;
    const std::int32_t from_plus = from_a ? t : certet::steps - t;
    const std::uint64_t h = mixed(seed + 1, a.x, a.y, a.z, b.x, b.y, b.z);
    const std::int32_t cut = cuts[h % cuts.size()];
    return from_plus <= cut ? Sign::plus : Sign::minus;
  });
}

}  // namespace domains
