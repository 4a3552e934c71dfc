#include "cuts.hpp"

#include <algorithm>
#include <array>

#include "layer_loop.hpp"

namespace certet::core {
namespace {

static_assert(step_bits == 16, "cuts are kept in 16 bits: 0 <= cut < steps, as BisectOnEdge says");

/// Bisects many edges in lockstep, so that the domain sees long batches and the
/// loops vectorise.
class Bisection {
 public:
  explicit Bisection(const Domain& domain) : domain_(domain) {}

  void add(Coord3 plus, Coord3 minus) {
    start_[size_] = steps * plus;
    towards_[size_] = minus - plus;
    if (++size_ == batch) flush();
  }

  /// Finishes what was added; the cuts stand in `result` in order.
  std::vector<std::uint16_t> finish() {
    flush();
    return std::move(result_);
  }

 private:
  static constexpr std::size_t batch = 256;

  void flush() {
    const std::size_t n = size_;
    std::fill_n(low_.begin(), n, 0);
    std::fill_n(open_.begin(), n, 1);
    for (int round = step_bits - 1; round >= 0; --round) halve(std::int32_t{1} << round);
    for (std::size_t e = 0; e < n; ++e) result_.push_back(static_cast<std::uint16_t>(low_[e]));
    size_ = 0;
  }

  /// One round: `low` is known to be inside, `low` + 2 `half` to be outside.  An
  /// edge is open until a position is found to lie on the surface.
  void halve(std::int32_t half) {
    const std::size_t n = size_;
    for (std::size_t e = 0; e < n; ++e)
      middle_[e] = start_[e] + (low_[e] + half) * towards_[e];
    domain_.at({middle_.data(), n}, {signs_.data(), n});
    for (std::size_t e = 0; e < n; ++e) {
      const auto sign = static_cast<std::int32_t>(signs_[e]);
      low_[e] += half & -(open_[e] & std::int32_t{sign != static_cast<int>(Sign::minus)});
      open_[e] &= std::int32_t{sign != static_cast<int>(Sign::on_surface)};
    }
  }

  const Domain& domain_;
  std::size_t size_ = 0;
  std::array<Coord3, batch> start_, towards_, middle_;
  std::array<std::int32_t, batch> low_, open_;
  std::array<Sign, batch> signs_;
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
  Bisection bisection(domain);
  RowRanks row;
  std::uint64_t count = 0;
  for (int j = 0; j < rows; ++j) {
    layer.row_begin.push_back(count);
    row.compute(planes, j, k);
    count += row.count() - row.corners();
    if (cuts == Cuts::bisect)
      for_each_cut_edge(planes, row, lattice, j, k,
                        [&](Coord3 plus, Coord3 minus) { bisection.add(plus, minus); });
  }
  if (cuts == Cuts::bisect) layer.steps = bisection.finish();
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
