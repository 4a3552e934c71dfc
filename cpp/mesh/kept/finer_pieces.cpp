#include "finer_pieces.hpp"

#include <algorithm>

#include "certet/error.hpp"
#include "engine/sampled_pieces.hpp"
#include "pruned.hpp"

namespace certet::core {
namespace {

/// No more, so that asking for the extents of blocks does not take longer than sampling.
constexpr double most_cells_in_all = 4e8, cells_per_sampled = 100;

/// A shape on a lattice of which small blocks are known.
class FineLattice {
 public:
  FineLattice(const SizedShape& shape, double size) : domain_(shape.place(size)) {}

  /// Whether no more than so many cells would have to be sampled.
  bool prune(double most_cells) {
    const auto& count = domain_->lattice().cells;
    cells_ = 1.0 * count[0] * count[1] * count[2];
    if (cells_ > std::min(most_cells_in_all, cells_per_sampled * most_cells)) return false;
    pruned_.emplace(*domain_);
    cells_ = pruned_->mixed_cells();
    return cells_ <= most_cells;
  }
  /// How many; all of them where these were too many to ask for the extents of blocks.
  [[nodiscard]] double cells() const { return cells_; }
  std::uint64_t pieces(Method method, Context& context) const {
    return count_sampled_pieces(*pruned_, domain_->lattice(), method, context);
  }

 private:
  std::shared_ptr<const PlacedDomain> domain_;
  std::optional<PrunedDomain> pruned_;
  double cells_ = 0;
};

/// Runs `work`; a lattice that is too large has nothing to tell.
template <class Work>
auto if_it_fits(const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::too_large) throw;
    return std::nullopt;
  }
}

}  // namespace

std::optional<std::uint64_t> pieces_at(const SizedShape& shape, double size, Method method,
                                       double most_cells, Context& context) {
  return if_it_fits([&]() -> std::optional<std::uint64_t> {
    FineLattice fine(shape, size);
    if (!fine.prune(most_cells)) return std::nullopt;
    return fine.pieces(method, context);
  });
}

std::variant<FinerPieces, UncomparedPieces> finer_pieces(const SizedShape& shape,
                                                         const MeshedShape& mesh,
                                                         Context& context) {
  // Looking is to take a quarter of the time that the mesh takes, or less.
  constexpr double cells_per_tet = 0.5, least_cells = 5e4;
  // A surface crosses four times as many cells of half the size.
  constexpr double more_cells = 4;
  const double most = std::max(cells_per_tet * static_cast<double>(mesh.tets), least_cells);
  const double size = mesh.domain.frame().size;
  const auto& count = mesh.domain.lattice().cells;
  UncomparedPieces uncompared{size / 2, 8.0 * count[0] * count[1] * count[2]};
  const auto found = if_it_fits([&]() -> std::optional<FinerPieces> {
    FineLattice half(shape, size / 2);
    const bool few = half.prune(most);
    uncompared.cells = half.cells();
    if (!few) return std::nullopt;
    if (more_cells * half.cells() <= most)
      if (const auto pieces = pieces_at(shape, size / 4, mesh.method, 2 * most, context))
        return FinerPieces{size / 4, *pieces};
    return FinerPieces{size / 2, half.pieces(mesh.method, context)};
  });
  if (found) return *found;
  return uncompared;
}

}  // namespace certet::core
