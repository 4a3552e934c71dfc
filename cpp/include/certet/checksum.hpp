#pragma once
/// \file
/// One number that tells whether two meshes are the same.

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <variant>

#include "certet/mesh.hpp"

namespace certet {

/// A 64-bit hash over the points, in steps, and the tetrahedra of a mesh, each
/// hashed with its number and added up modulo 2^64.  It depends on the mesh
/// alone: parts may be added in any order, from any number of threads, with
/// indices of either width.
class Checksum {
 public:
  /// `first` is the number of the first point (tetrahedron) given.
  void points(std::uint64_t first, std::span<const Coord3> points) {
    for (const Coord3 p : points)
      sum_ += hash(word(p.x) | word(p.y) << 32, word(p.z), point_key + first++);
  }

  /// Points as files have them.
  void points(std::uint64_t first, std::span<const Point3> points) {
    for (const Point3& p : points) {
      const auto bits = std::bit_cast<std::array<std::uint64_t, 3>>(p);
      sum_ += hash(bits[0] ^ std::rotl(bits[1], 21), bits[2] ^ std::rotl(bits[1], 42),
                   point_key + first++);
    }
  }

  template <class Index>
  void tets(std::uint64_t first, std::span<const Tet<Index>> tets) {
    for (const auto [a, b, c, d] : tets)
      sum_ += hash(std::uint64_t{a} ^ std::rotl(std::uint64_t{b}, 32),
                   std::uint64_t{c} ^ std::rotl(std::uint64_t{d}, 32), tet_key + first++);
  }

  Checksum& operator+=(const Checksum& other) {
    sum_ += other.sum_;
    return *this;
  }
  [[nodiscard]] std::uint64_t value() const { return sum_; }

 private:
  static constexpr std::uint64_t point_key = std::uint64_t{1} << 62;
  static constexpr std::uint64_t tet_key = std::uint64_t{1} << 63;

  static constexpr std::uint64_t word(std::int32_t number) {
    return static_cast<std::uint32_t>(number);
  }

  /// Both halves of a 128-bit product, one upon the other: every bit of the
  /// result hangs on every bit given.
  static constexpr std::uint64_t hash(std::uint64_t a, std::uint64_t b, std::uint64_t key) {
    const auto product = static_cast<Wide>(a + 0x9e3779b97f4a7c15 * key) *
                         (b ^ 0xbf58476d1ce4e5b9 * key);
    return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
  }
  __extension__ using Wide = unsigned __int128;

  std::uint64_t sum_ = 0;
};

/// Of a whole mesh.
inline std::uint64_t checksum(const Mesh& mesh) {
  Checksum sum;
  sum.points(0, mesh.points);
  std::visit(
      [&sum]<class Index>(const Buffer<Tet<Index>>& tets) {
        sum.tets(0, std::span<const Tet<Index>>(tets));
      },
      mesh.tets);
  return sum.value();
}

}  // namespace certet
