#include "sample.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "layer_loop.hpp"
#include "part_cubes.hpp"

namespace certet::core {
namespace {

/// The lattice is looked at in blocks of this many indices along each axis; a
/// block of one sign is never sampled.
constexpr int block = 16;
static_assert(64 % block == 0, "a block must not straddle two words");

constexpr int blocks_in(int n) { return (n + block - 1) / block; }

/// Bit 0 of each of eight bytes, as eight bits.  Byte n has it at 8n; the factor has a
/// bit at 7 m for m = 1 to 8, so that the product has a copy of it at 8n + 7m, and for
/// m = 8 - n at 56 + n.  No two copies fall on one bit, and nothing is carried.
constexpr std::uint64_t gather_low_bits(std::uint64_t bytes) {
  return (bytes & 0x0101010101010101) * 0x0102040810204080 >> 56;
}

static_assert(static_cast<int>(Sign::on_surface) == 1 && static_cast<int>(Sign::plus) == 2,
              "packing reads zero from bit 0 of a sign and plus from bit 1");

/// Packs 64 signs into a word of each plane.
SignWord pack(const Sign* signs) {
  SignWord word{0, 0};
  for (std::size_t group = 0; group < 8; ++group) {
    std::uint64_t bytes;
    if constexpr (std::endian::native == std::endian::little) {
      std::memcpy(&bytes, signs + 8 * group, 8);
    } else {
      bytes = 0;
      for (std::size_t i = 0; i < 8; ++i)
        bytes |= std::uint64_t{static_cast<std::uint8_t>(signs[8 * group + i])} << 8 * i;
    }
    word.zero |= gather_low_bits(bytes) << 8 * group;
    word.plus |= gather_low_bits(bytes >> 1) << 8 * group;
  }
  return word;
}

/// Where a solid is.
class SignSource {
 public:
  using Value = Sign;
  static constexpr Sign outside = Sign::minus;

  SignSource(const Domain& domain, Cuts cuts, SignPlanes& planes)
      : domain_(domain), surface_is_inside_(cuts == Cuts::midpoint), planes_(planes) {}

  [[nodiscard]] std::optional<Sign> value_of(const LatticeBox& box) const {
    switch (domain_.extent(box)) {
      case Extent::inside: return Sign::plus;
      case Extent::outside: return Sign::minus;
      case Extent::mixed: break;
    }
    return std::nullopt;
  }
  void row(Coord3 first, std::span<Sign> out) const { domain_.row(first, out); }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const {
    domain_.at(positions, out);
  }
  [[nodiscard]] std::size_t batch() const { return domain_.batch(); }

  /// `row` has 64 values for each word.
  void store(Grid grid, int j, int k, std::span<const Sign> row) const {
    std::uint64_t* const plus = planes_.plus(grid, j, k);
    std::uint64_t* const zero = planes_.zero(grid, j, k);
    for (int w = 0; w < planes_.words(); ++w) {
      const SignWord word = pack(&row[static_cast<std::size_t>(w) * 64]);
      plus[w] = surface_is_inside_ ? word.plus | word.zero : word.plus;
      zero[w] = surface_is_inside_ ? 0 : word.zero;
    }
  }

 private:
  const Domain& domain_;
  bool surface_is_inside_;
  SignPlanes& planes_;
};

/// Where each of several materials is.
class MaterialSource {
 public:
  using Value = Material;
  static constexpr Material outside = 0;

  MaterialSource(const Domain& domain, SignPlanes& planes, MaterialPlanes& materials)
      : domain_(domain), planes_(planes), materials_(materials) {}

  [[nodiscard]] std::optional<Material> value_of(const LatticeBox& box) const {
    return domain_.material_of(box);
  }
  void row(Coord3 first, std::span<Material> out) const { domain_.row_materials(first, out); }
  void at(std::span<const Coord3> positions, std::span<Material> out) const {
    domain_.materials_at(positions, out);
  }
  [[nodiscard]] std::size_t batch() const { return domain_.batch(); }

  void store(Grid grid, int j, int k, std::span<const Material> row) const {
    std::uint64_t* const plus = planes_.plus(grid, j, k);
    for (std::size_t i = 0; i < row.size(); ++i)
      plus[i >> 6] |= std::uint64_t{row[i] != 0} << (i & 63);
    materials_.set_row(grid, j, k, row);
  }

 private:
  const Domain& domain_;
  SignPlanes& planes_;
  MaterialPlanes& materials_;
};

/// Asks for runs of points of rows: at once, or many together where the domain likes that.
template <class Source>
class RunQueries {
 public:
  using Value = typename Source::Value;

  explicit RunQueries(const Source& source) : source_(source), batch_(source.batch()) {}

  /// Whether it is the next `flush` that writes what is asked for.
  [[nodiscard]] bool wait() const { return batch_ > usual; }

  /// Of points that are two lattice units apart.
  void ask(Coord3 first, std::span<Value> out) {
    if (!wait()) return source_.row(first, out);
    for (std::size_t i = 0; i < out.size(); ++i)
      positions_.push_back(steps * (first + Coord3{2 * static_cast<std::int32_t>(i), 0, 0}));
    runs_.push_back(out);
  }

  void flush() {
    for (std::size_t begin = 0; begin < positions_.size(); begin += batch_) {
      const std::size_t count = std::min(batch_, positions_.size() - begin);
      values_.resize(begin + count);
      source_.at(std::span(positions_).subspan(begin, count), std::span(values_).subspan(begin));
    }
    auto value = values_.begin();
    for (const std::span<Value> run : runs_) {
      const auto end = value + static_cast<std::ptrdiff_t>(run.size());
      std::copy(value, end, run.begin());
      value = end;
    }
    positions_.clear();
    values_.clear();
    runs_.clear();
  }

 private:
  static constexpr std::size_t usual = 256;

  const Source& source_;
  std::size_t batch_;
  std::vector<Coord3> positions_;
  std::vector<Value> values_;
  std::vector<std::span<Value>> runs_;
};

/// Samples the rows of one block-row: all indices i, `block` values of j and k.
template <class Source>
class BlockRowSampler {
 public:
  using Value = typename Source::Value;

  BlockRowSampler(const Source& source, const Lattice& lattice, const PlaneLayout& layout)
      : source_(source), lattice_(lattice), window_(layout.window()),
        known_(static_cast<std::size_t>(blocks_in(lattice.cells[0]))), queries_(source),
        width_(static_cast<std::size_t>(layout.words()) * 64),
        rows_at_once_(queries_.wait() ? std::size_t{block} * block * grids.size() : 1),
        values_(rows_at_once_ * width_) {}

  void sample(int block_j, int block_k) {
    const int j_begin = std::max(1, block_j * block);
    const int k_begin = std::max({1, block_k * block, window_.begin});
    const int j_end = std::min((block_j + 1) * block, lattice_.cells[1] - 1);
    const int k_end = std::min({(block_k + 1) * block, lattice_.cells[2] - 1, window_.end});
    if (!ask_blocks(block_j, block_k)) return;
    for (int k = k_begin; k < k_end; ++k)
      for (int j = j_begin; j < j_end; ++j)
        for (const Grid grid : grids) add_row({grid, j, k});
    store_rows();
  }

 private:
  struct Row {
    Grid grid;
    int j, k;
  };

  /// Whether there is anything to sample.
  bool ask_blocks(int block_j, int block_k) {
    bool any = false;
    for (std::size_t b = 0; b < known_.size(); ++b) {
      const Coord3 low = lattice_.origin + 2 * Coord3{static_cast<int>(b) * block,
                                                      block_j * block, block_k * block};
      known_[b] =
          source_.value_of({low, low + Coord3{2 * block - 1, 2 * block - 1, 2 * block - 1}});
      any = any || known_[b] != Source::outside;
    }
    return any;
  }

  /// Of the rows that wait, the one with this number.
  [[nodiscard]] std::span<Value> values(std::size_t row) {
    return std::span(values_).subspan(row * width_, width_);
  }

  void add_row(const Row& row) {
    fill_row(row, values(rows_.size()));
    rows_.push_back(row);
    if (rows_.size() == rows_at_once_) store_rows();
  }

  void fill_row(const Row& row, std::span<Value> values) {
    const int n = lattice_.cells[0];
    const int blocks = static_cast<int>(known_.size());
    for (int b = 0; b < blocks;) {
      const std::optional<Value> known = known_[static_cast<std::size_t>(b)];
      int e = b + 1;
      while (e < blocks && known_[static_cast<std::size_t>(e)] == known) ++e;
      const int begin = b * block;
      const std::span<Value> run = values.subspan(
          static_cast<std::size_t>(begin), static_cast<std::size_t>(std::min(e * block, n) - begin));
      if (known)
        std::ranges::fill(run, *known);
      else
        queries_.ask(lattice_.origin + 2 * Coord3{begin, row.j, row.k} + tiling.grids[row.grid],
                     run);
      b = e;
    }
  }

  void store_rows() {
    queries_.flush();
    const auto last = static_cast<std::size_t>(lattice_.cells[0] - 1);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const std::span<Value> row = values(r);
      row.front() = Source::outside;
      std::ranges::fill(row.subspan(last), Source::outside);
      source_.store(rows_[r].grid, rows_[r].j, rows_[r].k, row);
    }
    rows_.clear();
  }

  const Source& source_;
  const Lattice& lattice_;
  Window window_;
  std::vector<std::optional<Value>> known_;
  RunQueries<Source> queries_;
  std::size_t width_, rows_at_once_;
  std::vector<Value> values_;  ///< of all rows that wait
  std::vector<Row> rows_;
};

template <class Source>
void sample_blocks(const Source& source, const Lattice& lattice, const PlaneLayout& layout,
                   Context& context) {
  const Window window = layout.window();
  const int blocks_j = blocks_in(lattice.cells[1]);
  const int first_k = window.begin / block;
  const int blocks_k = blocks_in(window.end) - first_k;
  parallel_for(context, Stage::sample, std::int64_t{blocks_j} * blocks_k, [&](std::int64_t task) {
    BlockRowSampler(source, lattice, layout)
        .sample(static_cast<int>(task % blocks_j), first_k + static_cast<int>(task / blocks_j));
  });
}

SignPlanes sample_signs(const Domain& domain, const Lattice& lattice, Window window, Cuts cuts,
                        Context& context) {
  SignPlanes planes(lattice.cells, window);
  sample_blocks(SignSource(domain, cuts, planes), lattice, planes.layout(), context);
  return planes;
}

/// Whatever is not outside is plus.
SignPlanes sample_materials(const Domain& domain, const Lattice& lattice, Window window,
                            Context& context) {
  SignPlanes planes(lattice.cells, window);
  const auto materials = std::make_shared<MaterialPlanes>(
      planes.layout(), static_cast<Material>(domain.labels().size()));
  sample_blocks(MaterialSource(domain, planes, *materials), lattice, planes.layout(), context);
  for_each_layer(context, Stage::sample, window,
                 [&](std::int32_t k) { materials->find_parted_words(k); });
  planes.set_materials(materials);
  return planes;
}

}  // namespace

SignPlanes sample(const Domain& domain, const Lattice& lattice, Window window,
                  const MethodFacts& method, Context& context) {
  if (method.interfaces && domain.labels().size() > 1)
    return sample_materials(domain, lattice, window, context);
  if (!method.settles || !domain.even_points_tell_pieces())
    return sample_signs(domain, lattice, window, method.cuts, context);
  const Window wider = widened(window, 0, 1, lattice);
  SignPlanes planes = sample_signs(domain, lattice, wider, method.cuts, context);
  part_cubes(planes, window, context);
  if (wider.end == window.end) return planes;
  return {planes, window};
}

}  // namespace certet::core
