#include "warped_lattice.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "displaced_left.hpp"
#include "layer_loop.hpp"
#include "material_links.hpp"
#include "row_ranks.hpp"
#include "zero_tets.hpp"

namespace certet::core {
namespace {

/// Calls visit(grid, j, w) for every word of a layer.
template <class Visit>
void for_each_word(const SignPlanes& planes, const Visit& visit) {
  for (int j = 0; j < planes.cells()[1]; ++j)
    for (const Grid grid : grids)
      for (int w = 0; w < planes.words(); ++w) visit(grid, j, w);
}

/// Turns the zero vertices of layer k that have no plus neighbour to minus, 64 at once.
/// Picture: cpp/docs/pictures/pruning.svg.
void drop_idle_zeros_of(SignPlanes& planes, int k) {
  for_each_word(planes, [&](Grid grid, int j, int w) {
    std::uint64_t& zero = planes.zero(grid, j, k)[w];
    if (zero == 0) return;
    std::uint64_t any_plus = 0;
    for (std::size_t d = 0; d < tiling.directions.size(); ++d) {
      const VertexRef ref = neighbor(grid, d);
      any_plus |= shifted(planes.plus(ref.grid, j + ref.shift.y, k + ref.shift.z), w, ref.shift.x);
    }
    zero &= any_plus;
  });
}

/// The materials once vertices have moved: of those that did the lower of the two they
/// lay between.
std::shared_ptr<const MaterialPlanes> moved_materials(const MovedSigns& moved,
                                                      const Violations& violations,
                                                      const Lattice& lattice, Context& context) {
  const MaterialLinks links(moved.before, violations, lattice);
  auto materials = std::make_shared<MaterialPlanes>(*moved.before.materials());
  for_each_layer(context, Stage::warp, violations.violated.window(), [&](std::int32_t k) {
    for_each_word(moved.after, [&](Grid grid, int j, int w) {
      for_each_bit(moved.after.zero(grid, j, k)[w], [&](int b) {
        const VertexIndex v{grid, 64 * w + b, j, k};
        materials->set(v.grid, v.i, v.j, v.k, links.lower(v));
      });
    });
  });
  return materials;
}

/// The corners of tetrahedra of four zero vertices that are part of the mesh, in the zero
/// planes of what is returned.
SignPlanes corners_of_zero_tets(const SignPlanes& planes, Window window, Context& context) {
  SignPlanes corners(planes.cells(), window);
  for_each_layer(context, Stage::warp, window, [&](std::int32_t k) {
    for (const int z : {k - 1, k})
      for (int j = 0; j < planes.cells()[1]; ++j)
        for_each_zero_tet(planes, j, z, [&](const CaseIndex& tet) {
          if (material_of_zero_tet(planes, tet) == 0) return;
          for (std::size_t n = 0; n < 4; ++n)
            if (const VertexIndex v = tet.corner(n); v.k == k)
              corners.zero(v.grid, v.j, k)[v.i >> 6] |= std::uint64_t{1} << (v.i & 63);
        });
  });
  return corners;
}

/// The cuts of one layer that are left, each at least `least` away from both ends.
class RemainingCuts {
 public:
  RemainingCuts(const MovedSigns& moved, const CutLayer& cuts, const Thresholds& least)
      : moved_(moved), cuts_(cuts), least_(least) {}

  /// In the order of the new signs.
  CutLayer take(int k, WarpFigures& figures) {
    CutLayer left;
    for (int j = 0; j < moved_.after.cells()[1]; ++j) {
      old_row_.compute(moved_.before, j, k);
      new_row_.compute(moved_.after, j, k);
      left.row_begin.push_back(left.steps.size());
      for (std::size_t f = 0; f < family_count; ++f) take_family(f, j, left, figures);
    }
    return left;
  }

 private:
  void take_family(std::size_t f, int j, CutLayer& left, WarpFigures& figures) {
    const std::size_t kind = corner_kinds + f;
    const int direction = family_directions[f][0];
    const std::int32_t least = least_.in_steps(direction);
    CutShift& shift = is_long(direction) ? figures.long_edges : figures.short_edges;
    for (int w = 0; w < new_row_.words(); ++w)
      for_each_bit(new_row_.mask(kind, w), [&](int b) {
        const std::int32_t found = cut(kind, j, w, b);
        const std::int32_t kept = std::max(least, std::min(steps - least, found));
        if (kept != found) shift.add(std::abs(kept - found));
        left.steps.push_back(static_cast<std::uint16_t>(kept));
      });
  }

  /// A minus end that was sampled on the surface had no cut: it is at that end.
  [[nodiscard]] std::int32_t cut(std::size_t kind, int j, int w, int b) const {
    if ((old_row_.mask(kind, w) >> b & 1) == 0) return steps;
    return cuts_.at(j, old_row_, old_row_.rank(kind, w, b));
  }

  const MovedSigns& moved_;
  const CutLayer& cuts_;
  const Thresholds& least_;
  RowRanks old_row_, new_row_;
};

}  // namespace

SignPlanes move_all(const SignPlanes& planes, const Violations& violations, Context& context) {
  const Window window = violations.violated.window();
  SignPlanes after(planes, window);
  for_each_layer(context, Stage::warp, window, [&](std::int32_t k) {
    for_each_word(after, [&](Grid grid, int j, int w) {
      const std::uint64_t violated = violations.violated.plus(grid, j, k)[w];
      if (violated == 0) return;
      after.plus(grid, j, k)[w] &= ~violated;
      after.zero(grid, j, k)[w] |= violated;
    });
  });
  return after;
}

void drop_idle_zeros(SignPlanes& planes, Window window, Context& context) {
  std::optional<SignPlanes> corners;
  if (planes.materials() != nullptr) corners = corners_of_zero_tets(planes, window, context);
  for_each_layer(context, Stage::warp, window, [&](std::int32_t k) {
    drop_idle_zeros_of(planes, k);
    if (corners)
      for_each_word(planes, [&](Grid grid, int j, int w) {
        planes.zero(grid, j, k)[w] |= corners->zero(grid, j, k)[w];
      });
  });
}

WarpedLattice warp_lattice(MovedSigns moved, const Violations& violations,
                           const Layers<CutLayer>& cuts, const Thresholds& least,
                           const Lattice& lattice, Window window, Window counted,
                           Context& context) {
  if (moved.before.materials() != nullptr)
    moved.after.set_materials(moved_materials(moved, violations, lattice, context));
  const Window warped = warped_window(window, lattice);
  drop_idle_zeros(moved.after, warped, context);
  Layers<CutLayer> left(warped);
  Layers<DisplacedLayer> zeros(window);
  Layers<WarpFigures> layers(window);
  for_each_layer(context, Stage::warp, warped, [&](std::int32_t k) {
    WarpFigures figures;
    left[k] = RemainingCuts(moved, cuts[k], least).take(k, figures);
    if (!window.contains(k)) return;
    if (counted.contains(k)) layers[k] = figures;
    zeros[k] = displaced_left(
        violations.targets[k],
        [&](Grid grid, int j) { return violations.violated.plus(grid, j, k); }, moved.after, k);
  });
  WarpFigures figures;
  for (const WarpFigures& layer : layers) figures.add(layer);
  return {std::move(moved.after), std::move(left), std::move(zeros), figures};
}

WarpedLattice unwarped(SignPlanes planes, Layers<CutLayer> cuts, Window window) {
  Layers<DisplacedLayer> zeros(window);
  for (std::int32_t k = window.begin; k < window.end; ++k)
    zeros[k].row_begin.assign(static_cast<std::size_t>(planes.cells()[1]), 0);
  return {std::move(planes), std::move(cuts), std::move(zeros)};
}

}  // namespace certet::core
