#pragma once
/// \file
/// Domains of several materials, and whether what a domain says of its materials
/// is what it says of its solid.

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "certet/domain.hpp"
#include "certet/lattice.hpp"
#include "domains.hpp"
#include "random_blocks.hpp"
#include "seed.hpp"

namespace materials {

using certet::Coord3;
using certet::Material;
using certet::Sign;

/// A domain given by its material at any position, in steps.
class Positional : public certet::Domain {
 public:
  using MaterialAt = std::function<Material(Coord3)>;

  Positional(std::vector<std::int32_t> labels, MaterialAt material_at)
      : labels_(std::move(labels)), material_at_(std::move(material_at)) {}

  [[nodiscard]] Material material_at(Coord3 position) const { return material_at_(position); }
  [[nodiscard]] std::span<const std::int32_t> labels() const override { return labels_; }

  void row(Coord3 first, std::span<Sign> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = sign(nth(first, i));
  }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = sign(positions[i]);
  }
  void row_materials(Coord3 first, std::span<Material> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = material_at_(nth(first, i));
  }
  void materials_at(std::span<const Coord3> positions, std::span<Material> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = material_at_(positions[i]);
  }

 private:
  static Coord3 nth(Coord3 first, std::size_t i) {
    return certet::steps * (first + Coord3{2 * static_cast<std::int32_t>(i), 0, 0});
  }
  [[nodiscard]] Sign sign(Coord3 position) const {
    return material_at_(position) == 0 ? Sign::minus : Sign::plus;
  }

  std::vector<std::int32_t> labels_;
  MaterialAt material_at_;
};

/// Cubes of so many lattice units, of random materials; `outside` in 256ths say how
/// many are none.
inline Positional cubes(std::uint64_t seed, std::int32_t side, std::vector<std::int32_t> labels,
                        unsigned outside) {
  const auto count = labels.size();
  return {std::move(labels), [=](Coord3 p) -> Material {
            const auto cell = [&](std::int32_t c) {
              const std::int32_t width = side << certet::step_bits;
              return c >= 0 ? c / width : -1 - (-1 - c) / width;
            };
            const std::uint64_t h = mixed(seed, cell(p.x), cell(p.y), cell(p.z));
            return h % 256 < outside ? 0 : 1 + static_cast<Material>(h / 256 % count);
          }};
}

/// Noise of every frequency: each position has its own random material.
inline Positional noise(std::uint64_t seed, std::vector<std::int32_t> labels, unsigned outside) {
  const auto count = labels.size();
  return {std::move(labels), [=](Coord3 p) -> Material {
            const std::uint64_t h = mixed(seed, p.x, p.y, p.z);
            return h % 256 < outside ? 0 : 1 + static_cast<Material>(h / 256 % count);
          }};
}

/// Lattice points have random materials, and an edge between two is cut where `cuts` say:
/// one of them by chance, in steps from the end of the higher material.
inline Positional random_cuts(std::uint64_t seed, std::vector<std::int32_t> labels,
                              unsigned outside, std::vector<std::int32_t> cuts) {
  const auto count = labels.size();
  const auto corner = [=](Coord3 v) -> Material {
    const std::uint64_t h = mixed(seed, v.x, v.y, v.z);
    return h % 256 < outside ? 0 : 1 + static_cast<Material>(h / 256 % count);
  };
  return {std::move(labels), [=, cuts = std::move(cuts)](Coord3 p) -> Material {
            const auto [a, b, t] = domains::edge_of(p);
            const auto [low, high] = std::minmax(corner(a), corner(b));
            if (t == 0 || low == high) return corner(a);
            const std::int32_t from_high = corner(a) == high ? t : certet::steps - t;
            const std::uint64_t h = mixed(seed + 1, a.x, a.y, a.z, b.x, b.y, b.z);
            return from_high <= cuts[h % cuts.size()] ? high : low;
          }};
}

inline std::string text(Coord3 p) {
  return std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z);
}

/// Looks at a small block of the lattice; where two answers contradict each other,
/// says so.  Counts the blocks of which the material is known at once.
template <class Random>
std::string contradiction(Random& random, const certet::Domain& domain,
                          const certet::Lattice& lattice, int& decided) {
  constexpr int side = 4, last = 2 * side - 1;
  const Coord3 low = random_block(random, lattice, side);
  const std::optional<Material> whole =
      domain.material_of({low, low + Coord3{last, last, last}});
  if (whole) ++decided;
  const Material most = std::max<Material>(1, static_cast<Material>(domain.labels().size()));
  std::array<Sign, side> signs;
  std::array<Material, side> row, alone;
  std::array<Coord3, side> points;
  for (int z = 0; z <= last; ++z)
    for (int y = 0; y <= last; ++y)
      for (int x = 0; x < 2; ++x) {
        const Coord3 first = low + Coord3{x, y, z};
        domain.row(first, signs);
        domain.row_materials(first, row);
        for (std::int32_t i = 0; i < side; ++i)
          points[static_cast<std::size_t>(i)] = certet::steps * (first + Coord3{2 * i, 0, 0});
        domain.materials_at(points, alone);
        for (std::size_t i = 0; i < side; ++i) {
          const std::string where = " at " + text(points[i]);
          if (row[i] < 0 || row[i] > most) return "there is no such material" + where;
          if (row[i] != alone[i]) return "the row has another material" + where;
          if ((row[i] == 0) != (signs[i] == Sign::minus)) return "sign and material differ" + where;
          if (whole && row[i] != *whole) return "the block has another material" + where;
        }
      }
  return "";
}

/// The first contradiction of many blocks; empty if there is none.
template <class Random>
std::string first_contradiction(Random& random, const certet::Domain& domain,
                                const certet::Lattice& lattice, int blocks, int& decided) {
  return first_fault(blocks, [&] { return contradiction(random, domain, lattice, decided); });
}

}  // namespace materials
