#pragma once
/// \file
/// Tetrahedra that are translates of each other, counted instead of measured.

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "certet/lattice/coord3.hpp"
#include "tet_block.hpp"

namespace certet::core {

/// Edges of which no coordinate is greater have a determinant that fits 64 bits,
/// with all its intermediate values (`VolumesFit` of the certificate); those of
/// the output are half as long (`TetsNarrow`), or in graded meshes up to twice as long,
/// and theirs fit as well (`GradedVolumesFit`).
inline constexpr std::int64_t edge_limit = std::int64_t{1} << 19;

/// The vector between two positions in range, in steps, as two words that are
/// quickly subtracted and compared: x + 2^32 y, and z modulo 2^32.  Coordinates
/// in range are less than 2^32 - 2^20 apart, so that the words of an edge that
/// is not wide are those of no other.
struct LatticeEdge {
  std::uint64_t xy = 0;
  std::uint32_t z = 0;

  LatticeEdge() = default;
  LatticeEdge(Coord3 from, Coord3 to)
      : xy(word(to) - word(from)),
        z(static_cast<std::uint32_t>(to.z) - static_cast<std::uint32_t>(from.z)) {}

  [[nodiscard]] std::array<std::int64_t, 3> coordinates() const {
    const auto x = static_cast<std::int32_t>(xy);
    const std::uint64_t y = (xy - static_cast<std::uint64_t>(std::int64_t{x})) >> 32;
    return {x, static_cast<std::int32_t>(y), static_cast<std::int32_t>(z)};
  }

  [[nodiscard]] bool is_wide() const {
    return std::ranges::any_of(
        coordinates(), [](std::int64_t c) { return c < -2 * edge_limit || c > 2 * edge_limit; });
  }

  [[nodiscard]] Point3 exact() const {
    const auto [x, y, z] = coordinates();
    return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }

 private:
  static std::uint64_t word(Coord3 p) {
    return static_cast<std::uint64_t>(std::int64_t{p.x}) +
           (static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.y)) << 32);
  }
};

/// A tetrahedron but for its place: the edges from its first vertex.
struct LatticeShape {
  LatticeEdge a, b, c;

  LatticeShape() = default;
  explicit LatticeShape(const std::array<Coord3, 4>& corners)
      : a(corners[0], corners[1]), b(corners[0], corners[2]), c(corners[0], corners[3]) {}

  /// Without a branch for each word.
  friend bool operator==(const LatticeShape& p, const LatticeShape& q) {
    return ((p.a.xy ^ q.a.xy) | (p.b.xy ^ q.b.xy) | (p.c.xy ^ q.c.xy) | (p.a.z ^ q.a.z) |
            (p.b.z ^ q.b.z) | (p.c.z ^ q.c.z)) == 0;
  }

  [[nodiscard]] bool is_wide() const { return a.is_wide() || b.is_wide() || c.is_wide(); }
  [[nodiscard]] Edges exact() const { return {a.exact(), b.exact(), c.exact()}; }

  /// Smaller than 2^63 if no edge is wide.
  [[nodiscard]] std::int64_t determinant() const {
    const auto u = a.coordinates(), v = b.coordinates(), w = c.coordinates();
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
           u[2] * (v[0] * w[1] - v[1] * w[0]);
  }

  [[nodiscard]] std::uint64_t hash() const {
    std::uint64_t hash = 0;
    for (const LatticeEdge& edge : {a, b, c})
      hash = ((hash + edge.xy) * 0x9e3779b97f4a7c15 + edge.z) * 0x9e3779b97f4a7c15;
    return hash;
  }
};

/// A shape, and six times its volume, in steps cubed.
struct MeasuredShape {
  LatticeShape shape;
  std::int64_t six_volume = 0;
};

/// Counts shapes: away from the surface there are twelve, near it few or many,
/// depending on the cuts.  Remembers some, and lets go of those in the way.
class ShapeCounter {
 public:
  /// Counts so many copies of a shape; one that is new is first given to `first_seen(shape)`, and one
  /// that has to go to `release(measured shape, count)`.  \returns six times its volume.
  template <class FirstSeen, class Release>
  std::int64_t add(const LatticeShape& shape, std::uint64_t copies, const FirstSeen& first_seen,
                   const Release& release) {
    // What came next the last time mostly does so again.
    std::uint32_t at = entries_[last_].next;
    if (entries_[at].shape != shape || entries_[at].count == 0) {
      at = slot(shape);
      if (entries_[at].shape != shape || entries_[at].count == 0) {
        first_seen(shape);
        if (entries_[at].count != 0) release(entries_[at], entries_[at].count);
        entries_[at] = {{shape, shape.determinant()}, 0, at};
      }
      entries_[last_].next = at;
    }
    entries_[at].count += copies;
    last_ = at;
    return entries_[at].six_volume;
  }

  /// Lets go of all.
  template <class Release>
  void release_all(const Release& release) {
    for (Entry& entry : entries_)
      if (const std::uint64_t count = std::exchange(entry.count, 0); count != 0)
        release(entry, count);
  }

 private:
  static constexpr int slot_bits = 10;

  struct Entry : MeasuredShape {
    std::uint64_t count = 0;
    std::uint32_t next = 0;  ///< the slot that came after this one
  };

  static std::uint32_t slot(const LatticeShape& shape) {
    return static_cast<std::uint32_t>(shape.hash() >> (64 - slot_bits));
  }

  std::vector<Entry> entries_ = std::vector<Entry>(std::size_t{1} << slot_bits);
  std::uint32_t last_ = 0;
};

}  // namespace certet::core
