#pragma once
/// \file
/// Tetrahedra that are translates of each other, counted instead of measured.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "certet/coord3.hpp"
#include "tet_block.hpp"

namespace certet::quality {

/// The vector from one position to another, in steps.
struct LatticeEdge {
  std::int64_t x, y, z;

  LatticeEdge() = default;
  LatticeEdge(Coord3 from, Coord3 to)
      : x(std::int64_t{to.x} - from.x), y(std::int64_t{to.y} - from.y),
        z(std::int64_t{to.z} - from.z) {}
  friend bool operator==(const LatticeEdge&, const LatticeEdge&) = default;

  [[nodiscard]] Point3 exact() const {
    return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }
};

/// Edges of which no coordinate is greater have a determinant that fits 64 bits,
/// with all its intermediate values (`VolumesFit` of the certificate); those of
/// the output are half as long (`TetsNarrow`).
inline constexpr std::int64_t edge_limit = std::int64_t{1} << 19;

/// A tetrahedron but for its place: the edges from its first vertex.
struct LatticeShape {
  LatticeEdge a, b, c;

  friend bool operator==(const LatticeShape&, const LatticeShape&) = default;

  [[nodiscard]] Edges exact() const { return {a.exact(), b.exact(), c.exact()}; }
  [[nodiscard]] std::int64_t determinant() const {
    return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
           a.z * (b.x * c.y - b.y * c.x);
  }
};

/// Counts shapes: away from the surface there are twelve, near it few or many,
/// depending on the cuts.  Remembers some, and lets go of those in the way.
class ShapeCounter {
 public:
  /// Counts a shape; one that is new is first given to `judge(shape)`, and one
  /// that has to go to `release(shape, count)`.
  template <class Judge, class Release>
  void add(const LatticeShape& shape, const Judge& judge, const Release& release) {
    // What came next the last time mostly does so again.
    std::uint32_t at = entries_[last_].next;
    if (entries_[at].shape != shape || entries_[at].count == 0) {
      at = slot(shape);
      if (entries_[at].shape != shape || entries_[at].count == 0) {
        judge(shape);
        if (entries_[at].count != 0) release(entries_[at].shape, entries_[at].count);
        entries_[at] = {shape, 0, at};
      }
      entries_[last_].next = at;
    }
    ++entries_[at].count;
    last_ = at;
  }

  /// Lets go of all.
  template <class Release>
  void release_all(const Release& release) {
    for (Entry& entry : entries_)
      if (const std::uint64_t count = std::exchange(entry.count, 0); count != 0)
        release(entry.shape, count);
  }

 private:
  static constexpr int slot_bits = 10;

  struct Entry {
    LatticeShape shape{};
    std::uint64_t count = 0;
    std::uint32_t next = 0;  ///< the slot that came after this one
  };

  static std::uint32_t slot(const LatticeShape& shape) {
    std::uint64_t hash = 0;
    for (const LatticeEdge& edge : {shape.a, shape.b, shape.c})
      for (const std::int64_t coordinate : {edge.x, edge.y, edge.z})
        hash = (hash + static_cast<std::uint64_t>(coordinate)) * 0x9e3779b97f4a7c15;
    return static_cast<std::uint32_t>(hash >> (64 - slot_bits));
  }

  std::vector<Entry> entries_ = std::vector<Entry>(std::size_t{1} << slot_bits);
  std::uint32_t last_ = 0;
};

}  // namespace certet::quality
