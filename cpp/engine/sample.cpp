#include "sample.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

#include "parallel.hpp"
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

/// Samples the rows of one block-row: all indices i, `block` values of j and k.
class BlockRowSampler {
 public:
  BlockRowSampler(const Domain& domain, const Lattice& lattice, Cuts cuts, SignPlanes& planes)
      : domain_(domain), lattice_(lattice), surface_is_inside_(cuts == Cuts::midpoint),
        planes_(planes),
        extents_(static_cast<std::size_t>(blocks_in(lattice.cells[0]))),
        signs_(static_cast<std::size_t>(planes.words()) * 64) {}

  void sample(int block_j, int block_k) {
    const int j_begin = std::max(1, block_j * block);
    const int k_begin = std::max({1, block_k * block, planes_.window().begin});
    const int j_end = std::min((block_j + 1) * block, lattice_.cells[1] - 1);
    const int k_end = std::min({(block_k + 1) * block, lattice_.cells[2] - 1,
                                planes_.window().end});
    if (!find_extents(block_j, block_k)) return;
    for (int k = k_begin; k < k_end; ++k)
      for (int j = j_begin; j < j_end; ++j)
        for (const Grid grid : grids) sample_row(grid, j, k);
  }

 private:
  /// Whether there is anything to sample.
  bool find_extents(int block_j, int block_k) {
    bool any = false;
    for (std::size_t b = 0; b < extents_.size(); ++b) {
      const Coord3 low = lattice_.origin + 2 * Coord3{static_cast<int>(b) * block,
                                                      block_j * block, block_k * block};
      extents_[b] = domain_.extent({low, low + Coord3{2 * block - 1, 2 * block - 1, 2 * block - 1}});
      any = any || extents_[b] != Extent::outside;
    }
    return any;
  }

  void sample_row(Grid grid, int j, int k) {
    fill_signs(grid, j, k);
    std::uint64_t* const plus = planes_.plus(grid, j, k);
    std::uint64_t* const zero = planes_.zero(grid, j, k);
    for (int w = 0; w < planes_.words(); ++w) {
      const SignWord word = pack(&signs_[static_cast<std::size_t>(w) * 64]);
      plus[w] = surface_is_inside_ ? word.plus | word.zero : word.plus;
      zero[w] = surface_is_inside_ ? 0 : word.zero;
    }
  }

  void fill_signs(Grid grid, int j, int k) {
    const int n = lattice_.cells[0];
    const int blocks = static_cast<int>(extents_.size());
    for (int b = 0; b < blocks;) {
      int e = b + 1;
      while (e < blocks && extents_[static_cast<std::size_t>(e)] == extents_[static_cast<std::size_t>(b)]) ++e;
      const int begin = b * block;
      const std::span<Sign> run{&signs_[static_cast<std::size_t>(begin)],
                                static_cast<std::size_t>(std::min(e * block, n) - begin)};
      switch (extents_[static_cast<std::size_t>(b)]) {
        case Extent::inside: std::ranges::fill(run, Sign::plus); break;
        case Extent::outside: std::ranges::fill(run, Sign::minus); break;
        case Extent::mixed:
          domain_.row(lattice_.origin + 2 * Coord3{begin, j, k} + tiling.grids[grid], run);
      }
      b = e;
    }
    signs_.front() = Sign::minus;
    std::fill(signs_.begin() + (n - 1), signs_.end(), Sign::minus);
  }

  const Domain& domain_;
  const Lattice& lattice_;
  bool surface_is_inside_;
  SignPlanes& planes_;
  std::vector<Extent> extents_;
  std::vector<Sign> signs_;
};

SignPlanes sample_all(const Domain& domain, const Lattice& lattice, Window window, Cuts cuts,
                      Context& context) {
  SignPlanes planes(lattice.cells, window);
  const int blocks_j = blocks_in(lattice.cells[1]);
  const int first_k = window.begin / block;
  const int blocks_k = blocks_in(window.end) - first_k;
  parallel_for(context, Stage::sample, std::int64_t{blocks_j} * blocks_k, [&](std::int64_t task) {
    BlockRowSampler(domain, lattice, cuts, planes)
        .sample(static_cast<int>(task % blocks_j), first_k + static_cast<int>(task / blocks_j));
  });
  return planes;
}

}  // namespace

SignPlanes sample(const Domain& domain, const Lattice& lattice, Window window,
                  const MethodFacts& method, Context& context) {
  if (!method.settles || !domain.even_points_tell_pieces())
    return sample_all(domain, lattice, window, method.cuts, context);
  const Window wider = widened(window, 0, 1, lattice);
  SignPlanes planes = sample_all(domain, lattice, wider, method.cuts, context);
  part_cubes(planes, window, context);
  if (wider.end == window.end) return planes;
  return {planes, window};
}

}  // namespace certet::core
