#include "cuts.hpp"

#include <array>
#include <span>
#include <utility>

#include "layer_loop.hpp"

namespace certet::core {
namespace {

/// Asks the domain where many edges leave it, a batch at a time.
class Parting {
 public:
  explicit Parting(const Domain& domain) : domain_(domain) {}

  void add(Coord3 plus, Coord3 minus) {
    edges_[size_] = {plus, minus, 0};
    if (++size_ == edges_.size()) flush();
  }

  /// Finishes what was added; the cuts stand in `result` in order.
  std::vector<std::uint16_t> finish() {
    flush();
    return std::move(result_);
  }

 private:
  void flush() {
    const std::size_t before = result_.size();
    result_.resize(before + size_);
    domain_.part(std::span(edges_).first(size_), std::span(result_).subspan(before));
    size_ = 0;
  }

  const Domain& domain_;
  std::size_t size_ = 0;
  std::array<PartedEdge, 256> edges_;
  std::vector<std::uint16_t> result_;
};

/// Calls visit(plus_end, minus_end) for the cut edges of row (j,k), in the order
/// of `row`.
template <class Visit>
void for_each_cut_edge(const SignPlanes& planes, const RowRanks& row, const Lattice& lattice,
                       int j, int k, const Visit& visit) {
  for (std::size_t f = 0; f < family_count; ++f) {
    const Family& family = families[f];
    for (int w = 0; w < row.words(); ++w) {
      const std::uint64_t first_plus = planes.plus(family.first.grid, j, k)[w];
      for_each_bit(row.mask(corner_kinds + f, w), [&](int b) {
        const Coord3 first = lattice_point(lattice, family.first, 64 * w + b, j, k);
        const Coord3 second = lattice_point(lattice, family.second, 64 * w + b, j, k);
        if (first_plus >> b & 1) visit(first, second);
        else visit(second, first);
      });
    }
  }
}

CutLayer find_layer(const SignPlanes& planes, const Domain& domain, const Lattice& lattice,
                    Cuts cuts, int k) {
  CutLayer layer;
  const int rows = planes.cells()[1];
  layer.row_begin.reserve(static_cast<std::size_t>(rows));
  Parting parting(domain);
  RowRanks row;
  std::uint64_t count = 0;
  for (int j = 0; j < rows; ++j) {
    layer.row_begin.push_back(count);
    row.compute(planes, j, k);
    count += row.count() - row.corners();
    if (cuts == Cuts::bisect)
      for_each_cut_edge(planes, row, lattice, j, k,
                        [&](Coord3 plus, Coord3 minus) { parting.add(plus, minus); });
  }
  if (cuts == Cuts::bisect) layer.steps = parting.finish();
  else layer.steps.assign(count, midpoint_cut);
  return layer;
}

}  // namespace

Layers<CutLayer> find_cuts(const SignPlanes& planes, const Domain& domain, const Lattice& lattice,
                           Window window, Cuts cuts, Context& context) {
  Layers<CutLayer> layers(window);
  for_each_layer(context, Stage::cut, window, [&](std::int32_t k) {
    layers[k] = find_layer(planes, domain, lattice, cuts, k);
  });
  return layers;
}

}  // namespace certet::core
