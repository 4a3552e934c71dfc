#include "kept_pieces.hpp"

#include <fmt/format.h>

#include "certet/error.hpp"

namespace certet::command {

bool keeps_pieces(const ImageRegion& region, const PieceCount& mesh) {
  return region.pieces_by_corners <= mesh.by_faces && mesh.by_vertices <= region.pieces_by_faces;
}

std::string size_for_pieces(const KeepingSize::CountAt& count_at, double below,
                            const ImageRegion& region, Context& context) {
  constexpr double finer = 1.25;
  constexpr int most_tries = 12;
  SearchBudget budget;
  double finest = 0;
  try {
    for (int n = 0; n < most_tries; ++n) {
      // As it is printed, so that it is this size that was tried.
      const double size = std::stod(fmt::format("{:.4g}", below /= finer));
      const std::optional<Counted> counted = count_at(size, budget);
      if (!counted) break;
      finest = size;
      if (keeps_pieces(region, counted->stuffing.pieces(counted->source.frame, context).whole))
        return fmt::format("--size {:.4g} keeps them", size);
    }
  } catch (const Error& error) {
    if (error.code() != ErrorCode::too_large) throw;
  }
  return finest == 0 ? "smaller sizes would take too many tetrahedra to try"
                     : fmt::format("no size was found that keeps them, down to {:.4g}", finest);
}

}  // namespace certet::command
