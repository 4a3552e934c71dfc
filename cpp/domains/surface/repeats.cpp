#include "repeats.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "engine/disjoint_sets.hpp"
#include "edges.hpp"

namespace certet {
namespace {

/// A triangle by its corners alone, and whether it runs around them upwards.
struct Known {
  std::array<std::uint32_t, 3> corners;
  std::uint32_t triangle;
  bool upwards;
};

Known known(const TriangleSurface& surface, std::uint32_t triangle) {
  auto corners = surface.triangles[triangle];
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  const bool upwards = corners[1] < corners[2];
  if (!upwards) std::swap(corners[1], corners[2]);
  return {corners, triangle, upwards};
}

/// Triangles with the same corners.
struct Repeat {
  std::uint32_t kept;      ///< the first of those that run around as most of them do
  bool balanced;           ///< as many run around one way as the other
};

/// What becomes of the edges of a patch if it is kept, or dropped.
struct Patch {
  std::uint64_t edges = 0, odd_kept = 0, odd_dropped = 0;
  bool attached = false;  ///< to triangles that are there once
  bool balanced = true;

  [[nodiscard]] bool keep() const {
    if (odd_kept != odd_dropped) {
      if (odd_kept < odd_dropped) return true;
      if (attached) return false;
    }
    return !balanced || (!attached && odd_kept == 0);
  }
};

class Repeats {
 public:
  explicit Repeats(TriangleSurface& surface)
      : surface_(surface), repeat_of_(surface.triangles.size(), none) {
    find();
  }

  std::uint64_t drop() {
    if (repeats_.empty()) return 0;
    const std::vector<TriangleSide> sides = sides_of(surface_);
    DisjointSets sets(repeats_.size());
    for_each_edge(sides, [&](std::span<const TriangleSide> edge) { join(edge, sets); });
    std::map<std::uint32_t, Patch> patches;
    for (std::uint32_t r = 0; r < repeats_.size(); ++r)
      patches[sets.find(r)].balanced &= repeats_[r].balanced;
    for_each_edge(sides, [&](std::span<const TriangleSide> edge) { join_or_drop(edge, sets, patches); });
    return drop(sets, patches);
  }

 private:
  void find() {
    std::vector<Known> all;
    all.reserve(surface_.triangles.size());
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      all.push_back(known(surface_, t));
    std::sort(all.begin(), all.end(), [](const Known& a, const Known& b) {
      return std::tie(a.corners, a.triangle) < std::tie(b.corners, b.triangle);
    });
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
      while (end < all.size() && all[end].corners == all[begin].corners) ++end;
      if (end - begin > 1) add(std::span(all).subspan(begin, end - begin));
    }
  }

  void add(std::span<const Known> same) {
    const auto upwards = std::count_if(same.begin(), same.end(), [](const Known& k) { return k.upwards; });
    const auto downwards = std::ssize(same) - upwards;
    const bool most = upwards == downwards ? same[0].upwards : upwards > downwards;
    const auto first = std::find_if(same.begin(), same.end(),
                                    [most](const Known& k) { return k.upwards == most; });
    for (const Known& k : same)
      repeat_of_[k.triangle] = static_cast<std::uint32_t>(repeats_.size());
    repeats_.push_back({first->triangle, upwards == downwards});
  }

  void join(std::span<const TriangleSide> edge, DisjointSets& sets) const {
    std::uint32_t before = none;
    for (const TriangleSide& side : edge) {
      const std::uint32_t repeat = repeat_of_[side.triangle];
      if (repeat == none) continue;
      if (before != none) sets.join(before, repeat);
      before = repeat;
    }
  }

  void join_or_drop(std::span<const TriangleSide> edge, DisjointSets& sets,
             std::map<std::uint32_t, Patch>& patches) const {
    std::uint64_t others = 0, kept = 0;
    std::uint32_t patch = none;
    for (const TriangleSide& side : edge) {
      const std::uint32_t repeat = repeat_of_[side.triangle];
      others += repeat == none;
      if (repeat == none) continue;
      patch = sets.find(repeat);
      kept += repeats_[repeat].kept == side.triangle;
    }
    if (patch == none) return;
    Patch& of = patches[patch];
    ++of.edges;
    of.attached |= others > 0;
    of.odd_dropped += others % 2;
    of.odd_kept += (others + kept) % 2;
  }

  std::uint64_t drop(DisjointSets& sets, std::map<std::uint32_t, Patch>& patches) {
    std::vector<bool> dropped(surface_.triangles.size(), false);
    std::uint64_t left = surface_.triangles.size();
    for (std::uint32_t t = 0; t < dropped.size(); ++t) {
      const std::uint32_t repeat = repeat_of_[t];
      if (repeat == none) continue;
      dropped[t] = repeats_[repeat].kept != t || !patches[sets.find(repeat)].keep();
      left -= dropped[t];
    }
    // Sheets that are all there is: mostly closed ones are a solid with holes, and
    // others stay, with nothing inside.
    if (left == 0)
      for (std::uint32_t t = 0; t < dropped.size(); ++t) {
        const std::uint32_t repeat = repeat_of_[t];
        const Patch& patch = patches[sets.find(repeat)];
        dropped[t] = 2 * patch.odd_kept < patch.edges && repeats_[repeat].kept != t;
      }
    return drop_triangles(surface_, dropped);
  }

  TriangleSurface& surface_;
  std::vector<std::uint32_t> repeat_of_;  ///< of each triangle
  std::vector<Repeat> repeats_;
};

}  // namespace

std::uint64_t drop_triangles(TriangleSurface& surface, const std::vector<bool>& dropped) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    if (!dropped[t]) surface.triangles[kept++] = surface.triangles[t];
  const std::uint64_t gone = surface.triangles.size() - kept;
  surface.triangles.resize(kept);
  return gone;
}

std::uint64_t drop_collapsed(TriangleSurface& surface) {
  return std::erase_if(surface.triangles, [](const std::array<std::uint32_t, 3>& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  });
}

bool has_repeats(const TriangleSurface& surface, std::span<const TriangleSide> edge) {
  const auto third = [&](const TriangleSide& side) {
    return surface.triangles[side.triangle][(side.corner + 2U) % 3];
  };
  if (edge.size() == 2) return third(edge[0]) == third(edge[1]);
  std::vector<std::uint32_t> points;
  for (const TriangleSide& side : edge) points.push_back(third(side));
  std::sort(points.begin(), points.end());
  return std::adjacent_find(points.begin(), points.end()) != points.end();
}

std::uint64_t drop_repeats(TriangleSurface& surface) { return Repeats(surface).drop(); }

}  // namespace certet
