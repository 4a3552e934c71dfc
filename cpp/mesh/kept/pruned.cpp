#include "pruned.hpp"

#include <algorithm>

namespace certet::core {

PrunedDomain::PrunedDomain(const PlacedDomain& domain) : domain_(domain) {
  constexpr std::int32_t whole = side * parts;
  const auto blocks = [&](std::size_t axis) {
    return (2 * domain.lattice().cells[axis] + whole - 1) / whole * parts;
  };
  count_ = {blocks(0), blocks(1), blocks(2)};
  known_.assign(static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y) *
                    static_cast<std::size_t>(count_.z),
                Extent::mixed);
  for (std::int32_t z = 0; z < count_.z; z += parts)
    for (std::int32_t y = 0; y < count_.y; y += parts)
      for (std::int32_t x = 0; x < count_.x; x += parts) divide({x, y, z});
}

Extent PrunedDomain::extent_of(Coord3 block, std::int32_t length) const {
  const Coord3 low = domain_.lattice().origin + side * block;
  return domain_.extent({low, low + Coord3{length - 1, length - 1, length - 1}});
}

void PrunedDomain::divide(Coord3 block) {
  const Extent whole = extent_of(block, side * parts);
  for (std::int32_t n = 0; n < parts * parts * parts; ++n) {
    const Coord3 part = block + Coord3{n % parts, n / parts % parts, n / (parts * parts)};
    Extent& known = known_[index(part)];
    known = whole == Extent::mixed ? extent_of(part, side) : whole;
    if (known == Extent::mixed) mixed_cells_ += 0.125 * side * side * side;
  }
}

std::size_t PrunedDomain::index(Coord3 block) const {
  return static_cast<std::size_t>((std::int64_t{block.z} * count_.y + block.y) * count_.x +
                                  block.x);
}

Coord3 PrunedDomain::block_of(Coord3 point) const {
  const Coord3 at = point - domain_.lattice().origin;
  return {at.x / side, at.y / side, at.z / side};
}

Extent PrunedDomain::extent(const LatticeBox& box) const {
  const Coord3 low = block_of(box.low), high = block_of(box.high);
  const auto known = [&](Coord3 block) {
    return block.x < count_.x && block.y < count_.y && block.z < count_.z ? known_[index(block)]
                                                                          : Extent::mixed;
  };
  const Extent first = known(low);
  for (std::int32_t z = low.z; z <= high.z; ++z)
    for (std::int32_t y = low.y; y <= high.y; ++y)
      for (std::int32_t x = low.x; x <= high.x; ++x)
        if (known({x, y, z}) != first) return Extent::mixed;
  return first;
}

void PrunedDomain::row(Coord3 first, std::span<Sign> out) const {
  for (std::size_t begin = 0; begin < out.size();) {
    const Coord3 at = first + Coord3{2 * static_cast<std::int32_t>(begin), 0, 0};
    Coord3 block = block_of(at);
    const Extent known = known_[index(block)];
    while (block.x + 1 < count_.x && known_[index({block.x + 1, block.y, block.z})] == known)
      ++block.x;
    // The first point of the row that is beyond the blocks that are alike.
    const std::int32_t beyond = domain_.lattice().origin.x + side * (block.x + 1) - first.x;
    const std::size_t end = std::min(out.size(), static_cast<std::size_t>((beyond + 1) / 2));
    const std::span<Sign> some = out.subspan(begin, end - begin);
    if (known == Extent::mixed) domain_.row(at, some);
    else std::ranges::fill(some, known == Extent::inside ? Sign::plus : Sign::minus);
    begin = end;
  }
}

}  // namespace certet::core
