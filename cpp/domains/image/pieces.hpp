#pragma once
/// \file
/// How many pieces there are of each region of a grid, layer by layer.

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "certet/context.hpp"
#include "certet/error.hpp"

namespace certet {

/// Neighbouring elements of a row that belong to the same region.
struct Run {
  std::int64_t first, last;
  std::uint32_t region;
  std::uint32_t piece = 0;
};
using Row = std::vector<Run>;

/// A row that touches another one: so many rows on, in the same or the layer before;
/// an element i of the one touches i - below to i + above of the other.
struct Link {
  bool layer_before;
  std::int32_t rows;
  std::int64_t below, above;
};

/// Union and find over the runs of two layers; the layers before are only counted.
class PieceCounter {
 public:
  explicit PieceCounter(std::size_t regions) : pieces_(regions, 0) {}

  void add(Run& run) {
    run.piece = static_cast<std::uint32_t>(parent_.size());
    parent_.push_back(run.piece);
    ++pieces_[run.region];
  }

  void unite(const Row& row, const Row& other, const Link& link) {
    std::size_t begin = 0;
    for (const Run& run : row) {
      while (begin < other.size() && other[begin].last < run.first - link.below) ++begin;
      for (std::size_t i = begin; i < other.size() && other[i].first <= run.last + link.above;
           ++i)
        if (other[i].region == run.region && join(run.piece, other[i].piece))
          --pieces_[run.region];
    }
  }

  /// Forgets all pieces but those of a layer, which are numbered anew.
  void keep(std::vector<Row>& layer) {
    std::vector<std::uint32_t> number(parent_.size(), none), roots;
    for (Row& row : layer)
      for (Run& run : row) {
        const std::uint32_t root = find(run.piece);
        if (number[root] == none) {
          number[root] = static_cast<std::uint32_t>(roots.size());
          roots.push_back(number[root]);
        }
        run.piece = number[root];
      }
    parent_ = std::move(roots);
  }

  [[nodiscard]] const std::vector<std::uint64_t>& pieces() const { return pieces_; }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  std::uint32_t find(std::uint32_t piece) {
    while (parent_[piece] != piece) piece = parent_[piece] = parent_[parent_[piece]];
    return piece;
  }
  /// False where they are one piece already.
  bool join(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax({find(a), find(b)});
    parent_[high] = low;
    return low != high;
  }

  std::vector<std::uint32_t> parent_;
  std::vector<std::uint64_t> pieces_;
};

/// Of each region, the pieces of a grid of layers of rows.  `make(row, layer, runs)`
/// appends the runs of a row in order; `links(row)` gives the rows before it that it
/// touches.  \throws Error `cancelled`.
template <class Make, class Links>
std::vector<std::uint64_t> count_pieces(std::int32_t rows, std::int32_t layers,
                                        std::size_t regions, const Make& make,
                                        const Links& links, const Context& context) {
  PieceCounter counter(regions);
  std::vector<Row> before(static_cast<std::size_t>(rows)), current(before);
  for (std::int32_t layer = 0; layer < layers; ++layer) {
    stop_if_cancelled(context);
    for (std::int32_t r = 0; r < rows; ++r) {
      Row& row = current[static_cast<std::size_t>(r)];
      row.clear();
      make(r, layer, row);
      for (Run& run : row) counter.add(run);
      for (const Link& link : links(r)) {
        const std::int32_t other = r + link.rows;
        if (other < 0 || other >= rows) continue;
        counter.unite(row, (link.layer_before ? before : current)[static_cast<std::size_t>(other)],
                      link);
      }
    }
    counter.keep(current);
    std::swap(before, current);
  }
  return counter.pieces();
}

}  // namespace certet
