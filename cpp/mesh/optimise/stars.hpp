#pragma once
/// \file
/// Which tetrahedra are around some of the vertices of a mesh.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "certet/mesh.hpp"

namespace certet::optimising {

/// A tetrahedron, as one of its corners sees it.
class StarTet {
 public:
  StarTet() = default;
  StarTet(std::uint64_t tet, std::size_t corner) : number_(4 * tet + corner) {}
  [[nodiscard]] std::uint64_t tet() const { return number_ / 4; }
  [[nodiscard]] std::size_t corner() const { return number_ % 4; }

 private:
  std::uint64_t number_ = 0;
};

/// The tetrahedra around those vertices that are marked, by growing numbers.
class Stars {
 public:
  template <class Index>
  Stars(std::span<const Tet<Index>> tets, std::span<const std::uint8_t> marked);

  /// The vertices, by growing numbers.
  [[nodiscard]] std::span<const std::uint64_t> vertices() const { return vertices_; }
  /// Around `vertices()[i]`.
  [[nodiscard]] std::span<const StarTet> around(std::size_t i) const {
    return std::span<const StarTet>(tets_).subspan(first_[i], first_[i + 1] - first_[i]);
  }

 private:
  std::vector<std::uint64_t> vertices_, first_;
  std::vector<StarTet> tets_;
};

template <class Index>
Stars::Stars(std::span<const Tet<Index>> tets, std::span<const std::uint8_t> marked) {
  std::vector<std::uint32_t> place(marked.size());
  for (std::size_t v = 0; v < marked.size(); ++v)
    if (marked[v] != 0) {
      place[v] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back(v);
    }
  first_.resize(vertices_.size() + 1);
  std::vector<StarTet> found;
  found.reserve(32 * vertices_.size());  // about what there is around a vertex
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const auto& [a, b, c, d] = tets[t];
    if ((marked[a] | marked[b] | marked[c] | marked[d]) == 0) continue;
    for (std::size_t corner = 0; corner < 4; ++corner)
      if (marked[tets[t][corner]] != 0) found.emplace_back(t, corner);
  }
  const auto place_of = [&](StarTet at) { return place[tets[at.tet()][at.corner()]]; };
  for (const StarTet at : found) ++first_[place_of(at) + 1];
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  tets_.resize(found.size());
  std::vector<std::uint64_t> next(first_.begin(), first_.end() - 1);
  for (const StarTet at : found) tets_[next[place_of(at)]++] = at;
}

}  // namespace certet::optimising
