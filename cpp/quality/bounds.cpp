#include "certet/quality.hpp"

namespace certet {
namespace {

// The bounds as the theorems of coq/Certificate.v state them.
constexpr AngleBounds midpoint_bounds{30, 135, "MidpointBounds"};
constexpr AngleBounds dihedral_bounds{10.77, 164.76, "DihedralBounds"};
constexpr AngleBounds embedding_bounds{9.27, 161.46, "DihedralBoundsEmbedding"};

}  // namespace

AngleBounds proven_bounds(Cuts cuts, Guarantee guarantee) {
  // Midpoint cuts never warp a vertex, whatever the thresholds.
  if (cuts == Cuts::midpoint) return midpoint_bounds;
  return guarantee == Guarantee::angles ? dihedral_bounds : embedding_bounds;
}

bool within(const Quality& quality, const AngleBounds& bounds, double rounding) {
  return quality.nonpositive == 0 && quality.min_dihedral >= bounds.min_dihedral - rounding &&
         quality.max_dihedral <= bounds.max_dihedral + rounding;
}

}  // namespace certet
