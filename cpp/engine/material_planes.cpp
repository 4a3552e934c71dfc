#include "material_planes.hpp"

#include <algorithm>
#include <bit>

namespace certet::core {
namespace {

std::size_t digits_of(Material most) {
  return static_cast<std::size_t>(std::bit_width(static_cast<std::uint32_t>(most)));
}

}  // namespace

MaterialPlanes::MaterialPlanes(const PlaneLayout& layout, Material most)
    : layout_(layout), planes_(digits_of(most)), parted_words_(layout.size()) {
  for (auto& digit : planes_)
    for (std::vector<std::uint64_t>& words : digit) words.resize(layout.size());
}

void MaterialPlanes::set_row(Grid grid, int j, int k, std::span<const Material> row) {
  const std::size_t at = layout_.at(j, k);
  for (std::size_t i = 0; i < row.size();) {
    const std::size_t word_end = std::min(row.size(), (i | 63) + 1);
    std::size_t e = i + 1;
    while (e < word_end && row[e] == row[i]) ++e;
    const std::uint64_t run =
        (e - i == 64 ? ~std::uint64_t{0} : below(static_cast<int>(e - i))) << (i & 63);
    for (std::size_t b = 0; b < planes_.size(); ++b)
      if (row[i] >> b & 1) planes_[b][grid][at + (i >> 6)] |= run;
    i = e;
  }
}

void MaterialPlanes::set(Grid grid, int i, int j, int k, Material material) {
  const std::uint64_t bit = std::uint64_t{1} << (i & 63);
  for (std::size_t b = 0; b < planes_.size(); ++b) {
    std::uint64_t& word = planes_[b][grid][layout_.at(j, k) + static_cast<std::size_t>(i >> 6)];
    word = material >> b & 1 ? word | bit : word & ~bit;
  }
}

void MaterialPlanes::find_parted_words(int k) {
  for (int j = 0; j < layout_.cells()[1]; ++j)
    for (int w = 0; w < layout_.words(); ++w) {
      std::uint64_t any = 0;
      for (const std::uint64_t word : compare(j, k, w)) any |= word;
      parted_words_[layout_.at(j, k) + static_cast<std::size_t>(w)] = any != 0;
    }
}

Material MaterialPlanes::at(Grid grid, int i, int j, int k) const {
  Material material = 0;
  for (std::size_t b = 0; b < planes_.size(); ++b)
    material |= static_cast<Material>(row(b, {grid, {}}, j, k)[i >> 6] >> (i & 63) & 1) << b;
  return material;
}

std::array<std::uint64_t, family_count> MaterialPlanes::compare(int j, int k, int w) const {
  std::array<std::uint64_t, family_count> differ{};
  for (std::size_t b = 0; b < planes_.size(); ++b) {
    std::array<std::uint64_t, edge_end_count> end;
    for (std::size_t n = 0; n < edge_end_count; ++n)
      end[n] = shifted(row(b, edge_ends.vertices[n], j, k), w, edge_ends.vertices[n].shift.x);
    for (std::size_t f = 0; f < family_count; ++f)
      differ[f] |= end[edge_ends.of_family[f][0]] ^ end[edge_ends.of_family[f][1]];
  }
  return differ;
}

std::array<std::uint64_t, family_count> MaterialPlanes::parted(int j, int k, int w) const {
  if (!is_parted(j, k, w)) return {};
  return compare(j, k, w);
}

std::uint64_t MaterialPlanes::parted_along(Grid grid, int j, int k, int w) const {
  if (!is_parted(j, k, w)) return 0;
  std::uint64_t parted = 0;
  for (std::size_t b = 0; b < planes_.size(); ++b) {
    const std::uint64_t* const words = row(b, {grid, {}}, j, k);
    parted |= words[w] ^ shifted(words, w, 1);
  }
  return parted;
}

std::uint64_t MaterialPlanes::first_is_greater(std::size_t f, int j, int k, int w) const {
  std::uint64_t decided = 0;
  std::uint64_t greater = 0;
  for (std::size_t b = planes_.size(); b-- > 0;) {
    const Family& family = families[f];
    const std::uint64_t first = shifted(row(b, family.first, j, k), w, family.first.shift.x);
    const std::uint64_t second = shifted(row(b, family.second, j, k), w, family.second.shift.x);
    const std::uint64_t here = (first ^ second) & ~decided;
    greater |= here & first;
    decided |= here;
  }
  return greater;
}

std::uint64_t MaterialPlanes::uniform_cells(int j, int k, int w) const {
  // The edges between the vertices of a cell are owned by its own index and the next ones.
  const auto any_parted = [&] {
    for (const int y : {0, 1})
      for (const int z : {0, 1})
        for (const int x : {-1, 0, 1})
          if (is_parted(j + y, k + z, w + x)) return true;
    return false;
  };
  if (!any_parted()) return ~std::uint64_t{0};
  std::uint64_t uniform = ~std::uint64_t{0};
  for (std::size_t b = 0; b < planes_.size() && uniform != 0; ++b) {
    std::uint64_t all = ~std::uint64_t{0};
    std::uint64_t any = 0;
    for (const VertexRef& vertex : cell.vertices) {
      const std::uint64_t word = shifted(row(b, vertex, j, k), w, vertex.shift.x);
      all &= word;
      any |= word;
    }
    uniform &= all | ~any;
  }
  return uniform;
}

std::size_t MaterialPlanes::bytes() const {
  return layout_.size() * (planes_.size() * grid_count * sizeof(std::uint64_t) + 1);
}

}  // namespace certet::core
