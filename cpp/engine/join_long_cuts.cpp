#include <array>
#include <bit>
#include <cstddef>
#include <utility>

#include "layer_joins.hpp"

namespace certet::core {
namespace {

/// A family of long edges, and the four vertices around each, in turn.
struct LongFamily {
  std::size_t number;
  VertexRef first, second;
  std::array<VertexRef, 4> ring;
};

constexpr auto long_families = [] {
  std::array<LongFamily, 6> list{};
  std::size_t count = 0;
  for (std::size_t f = 0; f < family_count; ++f) {
    const std::uint8_t direction = family_directions[f][0];
    if (!is_long(direction)) continue;
    LongFamily& family = list[count++] = {f, families[f].first, families[f].second, {}};
    LinkSet rest = link_ring[direction];
    int d = std::countr_zero(rest);
    for (VertexRef& at : family.ring) {
      at = neighbor(family.first.grid, static_cast<std::size_t>(d));
      rest &= ~(LinkSet{1} << d);
      const LinkSet beside = rest & link_ring[static_cast<std::size_t>(d)];
      if (beside != 0) d = std::countr_zero(beside);
    }
  }
  return list;
}();

/// The long edges of a family that a word owns, and the signs around them.
class LongEdges {
 public:
  LongEdges(const PlusRuns& runs, const SignRows& signs, const LongFamily& family, int j, int k,
            int w, std::uint64_t parted)
      : runs_(runs), materials_(*runs.planes().materials()), family_(family), j_(j), k_(k), w_(w),
        first_(signs.at(family.first, w)), second_(signs.at(family.second, w)) {
    cut_ = parted & (first_.plus | second_.plus) & ~first_.zero & ~second_.zero;
    if (cut_ == 0) return;
    for (std::size_t n = 0; n < ring_.size(); ++n) ring_[n] = signs.at(family.ring[n], w);
  }

  void add(LayerJoins& found) const {
    if (cut_ == 0) return;
    add_ends(found);
    for (const std::size_t n : {0U, 1U}) {
      add_across(n, found);
      add_faults(n, found);
    }
  }

 private:
  [[nodiscard]] std::uint64_t between_materials() const {
    return cut_ & first_.plus & second_.plus;
  }

  [[nodiscard]] std::uint32_t run(const VertexRef& ref, int b) const {
    return runs_.run_of(VertexIndex{even, 64 * w_ + b, j_, k_}.at(ref));
  }

  /// The ends' tetrahedra share the cut, and a face if there are two zero vertices next to
  /// each other around it.  A plus vertex there has joined them already.
  void add_ends(LayerJoins& found) const {
    std::uint64_t any_plus = 0;
    std::uint64_t any_face = 0;
    for (std::size_t n = 0; n < ring_.size(); ++n) {
      any_plus |= ring_[n].plus;
      any_face |= ring_[n].zero & ring_[(n + 1) % 4].zero;
    }
    for_each_bit(between_materials() & ~any_plus, [&](int b) {
      auto& pairs = (any_face >> b & 1) != 0 ? found.by_faces : found.by_vertices;
      pairs.push_back({run(family_.first, b), run(family_.second, b)});
    });
  }

  /// What fills the space around a cut touches it: two vertices across from each other, of
  /// a material that neither end is of.
  void add_across(std::size_t n, LayerJoins& found) const {
    const VertexRef& one = family_.ring[n];
    const VertexRef& other = family_.ring[n + 2];
    std::uint64_t across = cut_ & ring_[n].plus & ring_[n + 2].plus;
    const auto alike = [&](const VertexRef& a, const VertexRef& b) {
      return across == 0 ? 0 : materials_.alike(a, b, j_, k_, w_);
    };
    across &= ~alike(one, family_.first);
    across &= ~alike(one, family_.second);
    across &= alike(one, other);
    for_each_bit(across,
                 [&](int b) { found.by_vertices.push_back({run(one, b), run(other, b)}); });
  }

  /// The outside on two sides of a cut makes one fan around it only if it is also between
  /// them on one side, and a material is on the other.
  void add_faults(std::size_t n, LayerJoins& found) const {
    const SignWord& one = ring_[n + 1];
    const SignWord& other = ring_[(n + 3) % 4];
    const std::uint64_t one_fan = (one.minus() & other.plus) | (one.plus & other.minus());
    const std::uint64_t outside = ring_[n].minus() & ring_[n + 2].minus();
    for_each_bit(between_materials() & outside & ~one_fan, [&](int b) {
      found.vertices.push_back({static_cast<std::uint8_t>(corner_kinds + family_.number),
                                64 * w_ + b, j_, k_});
    });
  }

  const PlusRuns& runs_;
  const MaterialPlanes& materials_;
  const LongFamily& family_;
  int j_, k_, w_;
  SignWord first_, second_;
  std::uint64_t cut_;
  std::array<SignWord, 4> ring_{};
};

}  // namespace

void add_long_cuts(const PlusRuns& runs, std::int32_t k, LayerJoins& found) {
  const SignPlanes& planes = runs.planes();
  if (planes.materials() == nullptr) return;
  for (int j = 0; j < planes.cells()[1]; ++j) {
    const SignRows signs(planes, j, k);
    for (int w = 0; w < planes.words(); ++w) {
      const auto parted = planes.materials()->parted(j, k, w);
      for (const LongFamily& family : long_families)
        if (parted[family.number] != 0)
          LongEdges(runs, signs, family, j, k, w, parted[family.number]).add(found);
    }
  }
}

}  // namespace certet::core
