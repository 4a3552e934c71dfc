#pragma once
/// \file
/// One number that tells whether two meshes are the same.

#include <bit>
#include <cstdint>
#include <span>

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
    for (const Coord3 p : points) {
      std::uint64_t hash = mix(point_seed ^ first++);
      for (const std::int32_t c : {p.x, p.y, p.z})
        hash = mix(hash ^ static_cast<std::uint64_t>(std::int64_t{c}));
      sum_ += hash;
    }
  }

  /// Points as files have them.
  void points(std::uint64_t first, std::span<const Point3> points) {
    for (const Point3& p : points) {
      std::uint64_t hash = mix(point_seed ^ first++);
      for (const double c : p) hash = mix(hash ^ std::bit_cast<std::uint64_t>(c));
      sum_ += hash;
    }
  }

  template <class Index>
  void tets(std::uint64_t first, std::span<const Tet<Index>> tets) {
    for (const Tet<Index>& tet : tets) {
      std::uint64_t hash = mix(tet_seed ^ first++);
      for (const Index corner : tet) hash = mix(hash ^ std::uint64_t{corner});
      sum_ += hash;
    }
  }

  Checksum& operator+=(const Checksum& other) {
    sum_ += other.sum_;
    return *this;
  }
  [[nodiscard]] std::uint64_t value() const { return sum_; }

 private:
  static constexpr std::uint64_t point_seed = 0x9e3779b97f4a7c15;
  static constexpr std::uint64_t tet_seed = 0xc2b2ae3d27d4eb4f;

  /// A bijection in which every bit of the result hangs on every bit given.
  static constexpr std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
  }

  std::uint64_t sum_ = 0;
};

}  // namespace certet
