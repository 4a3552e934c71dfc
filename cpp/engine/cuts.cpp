#include "cuts.hpp"

#include <span>
#include <utility>

#include "layer_loop.hpp"

namespace certet::core {
namespace {

/// Asks the domain where many edges leave a material, a batch at a time.
class Parting {
 public:
  explicit Parting(const Domain& domain) : domain_(domain), edges_(domain.batch()) {}

  /// From the greater material to the lesser.
  void add(const PartedEdge& edge) {
    edges_[size_] = edge;
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
  std::vector<PartedEdge> edges_;
  std::vector<std::uint16_t> result_;
};

/// The material of an end of a cut edge, seen from bit b of word w; 0 where materials are not
/// told apart.
Material material_of(const SignPlanes& planes, const VertexRef& end, int w, int b, int j, int k) {
  if (planes.materials() == nullptr) return 0;
  return planes.materials()->at(end.grid, 64 * w + b + end.shift.x, j + end.shift.y,
                                k + end.shift.z);
}

/// Calls visit(edge) for the cut edges of row (j,k), in the order
/// of `row`: from the greater material to the lesser, or from plus to minus.
template <class Visit>
void for_each_cut_edge(const SignPlanes& planes, const RowRanks& row, const Lattice& lattice,
                       int j, int k, const Visit& visit) {
  for (std::size_t f = 0; f < family_count; ++f) {
    const Family& family = families[f];
    for (int w = 0; w < row.words(); ++w) {
      const std::uint64_t mask = row.mask(corner_kinds + f, w);
      if (mask == 0) continue;
      const std::uint64_t from_first = planes.measured_from_first(f, j, k, w);
      for_each_bit(mask, [&](int b) {
        const bool forward = (from_first >> b & 1) != 0;
        const VertexRef& from = forward ? family.first : family.second;
        const VertexRef& to = forward ? family.second : family.first;
        visit(PartedEdge{lattice_point(lattice, from, 64 * w + b, j, k),
                         lattice_point(lattice, to, 64 * w + b, j, k),
                         material_of(planes, to, w, b, j, k),
                         material_of(planes, from, w, b, j, k)});
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
                        [&](const PartedEdge& edge) { parting.add(edge); });
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
