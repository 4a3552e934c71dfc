#include "smoothed_labels.hpp"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <algorithm>
#include <cstring>
#include <span>

#include "fields/field_tile.hpp"

namespace certet::fields {
namespace {

constexpr std::size_t length = SmoothedLabels::row_length;

/// Elements that are there already are not made again: each is written before it is read.
void grow(std::vector<std::uint16_t>& values, std::size_t size) {
  if (values.size() < size) values.resize(size);
}

/// Of a row.
using EightShorts [[gnu::vector_size(16)]] = std::uint16_t;

/// Adds the upper halves of products.
[[gnu::always_inline]] inline void add_times(const std::uint16_t* row, const EightShorts& weights,
                                             EightShorts& sum) {
  EightShorts eight;
  std::memcpy(&eight, row, sizeof(eight));
#ifdef __SSE2__
  sum += reinterpret_cast<EightShorts>(_mm_mulhi_epu16(reinterpret_cast<__m128i>(eight),
                                                       reinterpret_cast<__m128i>(weights)));
#else
  for (std::size_t x = 0; x < 8; ++x)
    sum[x] = static_cast<std::uint16_t>(sum[x] + ((std::uint32_t{eight[x]} * weights[x]) >> 16));
#endif
}

/// Rows that lie `stride` apart, with weights in 65536ths each.
void add_rows(const std::uint16_t* rows, std::size_t stride,
              std::span<const std::uint16_t> weights, std::uint16_t* sum) {
  static_assert(length == 3 * 8, "three registers hold a row");
  EightShorts first{}, second{}, third{};
  for (const std::uint16_t weight : weights) {
    EightShorts of_weight = EightShorts{} + weight;
    add_times(rows, of_weight, first);
    add_times(rows + 8, of_weight, second);
    add_times(rows + 16, of_weight, third);
    rows += stride;
  }
  std::memcpy(sum, &first, sizeof(first));
  std::memcpy(sum + 8, &second, sizeof(second));
  std::memcpy(sum + 16, &third, sizeof(third));
}

/// Row number `at` of rows that start with number `low`, smoothed across them.
void smooth_across(const std::uint16_t* rows, std::size_t stride, int low, int high, int at,
                   const Taps& taps, std::uint16_t* sum) {
  if (taps.weights.empty()) {
    std::copy_n(rows + static_cast<std::size_t>(at - low) * stride, length, sum);
    return;
  }
  const int radius = taps.radius();
  const int first = std::max(low, at - radius), last = std::min(high, at + radius);
  if (first > last) return static_cast<void>(std::fill_n(sum, length, std::uint16_t{0}));
  add_rows(rows + static_cast<std::size_t>(first - low) * stride, stride,
           std::span(taps.weights).subspan(static_cast<std::size_t>(first - at + radius),
                                           static_cast<std::size_t>(last - first + 1)),
           sum);
}

/// The indicator of a label along a row of the window, smoothed at the tile's nodes.
void smooth_row(const LabelWindow& window, std::size_t first, std::uint16_t rank,
                const Taps& taps, std::uint16_t* sum) {
  std::array<std::uint16_t, length + 2 * greatest_radius + 8> is{};
  const auto width = static_cast<std::size_t>(window.width);
  const std::uint16_t* ranks = &window.ranks[first];
  for (std::size_t x = 0; x < width; ++x) is[x] = ranks[x] == rank ? field_one : 0;
  if (!window.parts.empty()) {
    const std::uint16_t *part = &window.parts[first], *receiver = &window.receivers[first];
    for (std::size_t x = 0; x < width; ++x)
      is[x] = static_cast<std::uint16_t>(is[x] - (ranks[x] == rank ? part[x] : 0) +
                                         (receiver[x] == rank ? part[x] : 0));
  }
  const std::uint16_t* from = is.data() + window.halo - taps.radius();
  if (taps.weights.empty()) {
    std::copy_n(from, length, sum);
  } else {
    add_rows(from, 1, taps.weights, sum);
  }
  std::fill(sum + tile_nodes, sum + length, std::uint16_t{0});
}

}  // namespace

void SmoothedLabels::compute(const LabelWindow& window, const std::array<Taps, 3>& taps) {
  find_supports(window);
  used_ = 0;
  for (std::size_t rank = 0; rank < supports_.size(); ++rank) smooth(window, rank, taps);
}

void SmoothedLabels::find_supports(const LabelWindow& window) {
  supports_.assign(window.materials.size(), {{window.width, window.width}, {-1, -1}});
  const std::uint16_t* rank = window.ranks.data();
  for (int z = 0; z < window.width; ++z)
    for (int y = 0; y < window.width; ++y)
      for (int x = 0; x < window.width; ++x, ++rank) {
        if (x > 0 && *rank == rank[-1]) continue;
        reach(*rank, y, z);
      }
  if (window.parts.empty()) return;
  for (std::size_t n = 0; n < window.parts.size(); ++n) {
    if (window.parts[n] == 0) continue;
    const auto row = static_cast<int>(n / static_cast<std::size_t>(window.width));
    reach(window.receivers[n], row % window.width, row / window.width);
  }
}

void SmoothedLabels::reach(std::size_t rank, int y, int z) {
  Support& s = supports_[rank];
  s.low = {std::min(s.low[0], y), std::min(s.low[1], z)};
  s.high = {std::max(s.high[0], y), std::max(s.high[1], z)};
}

void SmoothedLabels::smooth(const LabelWindow& window, std::size_t rank,
                            const std::array<Taps, 3>& taps) {
  const Support voxels = supports_[rank];
  Support& nodes = supports_[rank];
  for (std::size_t a = 0; a < 2; ++a) {
    const int radius = taps[a + 1].radius();
    nodes.low[a] = std::max(voxels.low[a] - radius - window.halo, 0);
    nodes.high[a] = std::min(voxels.high[a] + radius - window.halo, tile_nodes - 1);
  }
  nodes.first = used_;
  if (nodes.low[0] > nodes.high[0] || nodes.low[1] > nodes.high[1]) return;
  const auto rows = static_cast<std::size_t>(voxels.high[0] - voxels.low[0] + 1);
  const auto layers = static_cast<std::size_t>(voxels.high[1] - voxels.low[1] + 1);
  const auto rows_out = static_cast<std::size_t>(nodes.high[0] - nodes.low[0] + 1);
  const auto layers_out = static_cast<std::size_t>(nodes.high[1] - nodes.low[1] + 1);

  grow(along_x_, layers * rows * length);
  std::uint16_t* out = along_x_.data();
  for (int z = voxels.low[1]; z <= voxels.high[1]; ++z)
    for (int y = voxels.low[0]; y <= voxels.high[0]; ++y, out += length)
      smooth_row(window, window.at(0, y, z), static_cast<std::uint16_t>(rank), taps[0], out);

  grow(along_y_, layers * rows_out * length);
  out = along_y_.data();
  for (std::size_t z = 0; z < layers; ++z)
    for (int y = nodes.low[0]; y <= nodes.high[0]; ++y, out += length)
      smooth_across(&along_x_[z * rows * length], length, voxels.low[0], voxels.high[0],
                    y + window.halo, taps[1], out);

  used_ += layers_out * rows_out * length;
  grow(values_, used_);
  out = &values_[nodes.first];
  for (int z = nodes.low[1]; z <= nodes.high[1]; ++z)
    for (std::size_t y = 0; y < rows_out; ++y, out += length)
      smooth_across(&along_y_[y * length], rows_out * length, voxels.low[1], voxels.high[1],
                    z + window.halo, taps[2], out);
}

}  // namespace certet::fields
