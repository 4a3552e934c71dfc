#include "material_planes.hpp"

#include <algorithm>
#include <bit>

#include "row_ranks.hpp"

namespace certet::core {
namespace {

int digits_of(Material most) {
  return static_cast<int>(std::bit_width(static_cast<std::uint32_t>(most)));
}

}  // namespace

MaterialPlanes::MaterialPlanes(const PlaneLayout& layout, Material most)
    : layout_(layout), digits_(digits_of(most)), parted_words_(layout.size()) {
  for (std::vector<std::uint64_t>& words : words_)
    words.resize(layout.size() * static_cast<std::size_t>(digits_));
  // One vertex beyond the last row of the last layer.
  plane_size_ = byte_at(layout.cells()[0], layout.cells()[1], layout.window().end) + 1;
  for (std::vector<std::uint8_t>& bytes : bytes_)
    bytes.resize(plane_size_ * static_cast<std::size_t>(byte_count()));
}

void MaterialPlanes::set_row(Grid grid, int j, int k, std::span<const Material> row) {
  for (std::size_t i = 0; i < row.size();) {
    const std::size_t word_end = std::min(row.size(), (i | 63) + 1);
    std::size_t e = i + 1;
    while (e < word_end && row[e] == row[i]) ++e;
    const std::uint64_t run =
        (e - i == 64 ? ~std::uint64_t{0} : below(static_cast<int>(e - i))) << (i & 63);
    std::uint64_t* const digits = &words_[grid][begin(j, k, static_cast<int>(i >> 6))];
    for (int d = 0; d < digits_; ++d)
      if (row[i] >> d & 1) digits[d] |= run;
    i = e;
  }
  const auto count = static_cast<std::size_t>(layout_.cells()[0]);
  std::uint8_t* const bytes = &bytes_[grid][byte_at(0, j, k)];
  for (int byte = 0; byte < byte_count(); ++byte)
    for (std::size_t i = 0; i < count; ++i)
      bytes[static_cast<std::size_t>(byte) * plane_size_ + i] =
          static_cast<std::uint8_t>(row[i] >> 8 * byte);
}

void MaterialPlanes::set(Grid grid, int i, int j, int k, Material material) {
  const std::uint64_t bit = std::uint64_t{1} << (i & 63);
  std::uint64_t* const digits = &words_[grid][begin(j, k, i >> 6)];
  for (int d = 0; d < digits_; ++d)
    digits[d] = material >> d & 1 ? digits[d] | bit : digits[d] & ~bit;
  set_byte(grid, byte_at(i, j, k), material);
}

void MaterialPlanes::clear(Grid grid, int j, int k, int w, std::uint64_t vertices) {
  std::uint64_t* const digits = &words_[grid][begin(j, k, w)];
  for (int d = 0; d < digits_; ++d) digits[d] &= ~vertices;
  for_each_bit(vertices, [&](int b) { set_byte(grid, byte_at(64 * w + b, j, k), 0); });
}

void MaterialPlanes::find_parted_words(int k) {
  for (int j = 0; j < layout_.cells()[1]; ++j)
    for (int w = 0; w < layout_.words(); ++w) {
      std::uint64_t any = 0;
      for (const std::uint64_t word : compare(j, k, w)) any |= word;
      parted_words_[layout_.at(j, k) + static_cast<std::size_t>(w)] = any != 0;
    }
}

std::uint64_t MaterialPlanes::alike(VertexRef a, VertexRef b, int j, int k, int w) const {
  std::uint64_t differ = 0;
  for (int d = 0; d < digits_; ++d) differ |= digit(d, a, j, k, w) ^ digit(d, b, j, k, w);
  return ~differ;
}

std::array<std::uint64_t, family_count> MaterialPlanes::compare(int j, int k, int w) const {
  const auto rows = rows_at(edge_ends.vertices, j, k);
  std::array<std::uint64_t, family_count> differ{};
  for (int d = 0; d < digits_; ++d) {
    std::array<std::uint64_t, edge_end_count> end;
    for (std::size_t n = 0; n < edge_end_count; ++n)
      end[n] = shifted(rows[n] + d, w, edge_ends.vertices[n].shift.x, digits_);
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
  return ~alike({grid, {}}, {grid, {1, 0, 0}}, j, k, w);
}

std::uint64_t MaterialPlanes::first_is_greater(std::size_t f, int j, int k, int w) const {
  std::uint64_t decided = 0;
  std::uint64_t greater = 0;
  for (int d = digits_; d-- > 0;) {
    const std::uint64_t first = digit(d, families[f].first, j, k, w);
    const std::uint64_t second = digit(d, families[f].second, j, k, w);
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
  const auto rows = rows_at(cell.vertices, j, k);
  std::uint64_t uniform = ~std::uint64_t{0};
  for (int d = 0; d < digits_ && uniform != 0; ++d) {
    std::uint64_t all = ~std::uint64_t{0};
    std::uint64_t any = 0;
    for (std::size_t n = 0; n < cell_vertex_count; ++n) {
      const std::uint64_t word = shifted(rows[n] + d, w, cell.vertices[n].shift.x, digits_);
      all &= word;
      any |= word;
    }
    uniform &= all | ~any;
  }
  return uniform;
}

std::size_t MaterialPlanes::bytes() const {
  return layout_.size() *
             (static_cast<std::size_t>(digits_) * grid_count * sizeof(std::uint64_t) + 1) +
         grid_count * plane_size_ * static_cast<std::size_t>(byte_count());
}

}  // namespace certet::core
