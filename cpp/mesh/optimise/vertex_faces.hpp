#pragma once
/// \file
/// The faces at a vertex, brought together two by two.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace certet::optimising {

/// A face at a vertex that is on a surface, as the tetrahedron within has it.
struct VertexFace {
  std::array<std::uint64_t, 2> others;  ///< its other points, counterclockwise from outside
  std::int32_t label = 0;               ///< within
  std::int32_t beyond = 0;
  bool outer = true;  ///< nothing is beyond
};

/// Finds those faces at a vertex that one tetrahedron has alone, or two of different labels.
class VertexFaces {
 public:
  /// Of a vertex with so many faces, each counted as often as there are tetrahedra that have it.
  void start(std::size_t count) {
    const std::size_t size = std::bit_ceil(2 * count);
    if (slots_.size() < size) slots_.assign(size, Slot{});
    used_.clear();
    ++vertex_;
  }

  void add(std::uint64_t next, std::uint64_t last, std::int32_t label) {
    const std::size_t mask = slots_.size() - 1;
    const auto pair = ordered(next, last);
    const auto [low, high] = pair;
    std::size_t at = static_cast<std::size_t>((low * 0x9e3779b97f4a7c15U + high) *
                                              0xbf58476d1ce4e5b9U >> 40) & mask;
    for (; slots_[at].vertex == vertex_; at = (at + 1) & mask)
      if (ordered(slots_[at].face.others[0], slots_[at].face.others[1]) == pair)
        return join(slots_[at], next, last, label);
    slots_[at] = {{{next, last}, label}, vertex_, true};
    used_.push_back(at);
  }

  /// Those on surfaces, by growing numbers of points, into `out`.
  void surfaces(std::vector<VertexFace>& out) const {
    out.clear();
    for (const std::size_t at : used_)
      if (slots_[at].open) out.push_back(slots_[at].face);
    std::ranges::sort(out, {}, &VertexFace::others);
  }

 private:
  struct Slot {
    VertexFace face{};
    std::uint64_t vertex = 0;  ///< which had it last
    bool open = false;
  };

  static std::pair<std::uint64_t, std::uint64_t> ordered(std::uint64_t a, std::uint64_t b) {
    return {std::min(a, b), std::max(a, b)};
  }

  /// The lesser label is within.
  static void join(Slot& slot, std::uint64_t next, std::uint64_t last, std::int32_t label) {
    VertexFace& face = slot.face;
    slot.open = label != face.label;
    face.outer = false;
    if (label < face.label) face = {{next, last}, label, face.label, false};
    else face.beyond = label;
  }

  std::vector<Slot> slots_;
  std::vector<std::size_t> used_;
  std::uint64_t vertex_ = 0;  ///< how many there have been
};

}  // namespace certet::optimising
