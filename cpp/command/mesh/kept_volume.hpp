#pragma once
/// \file
/// How much of a solid its mesh keeps, and a size at which it keeps it.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "source.hpp"
#include "target_size.hpp"

namespace certet::command {

/// What is lost or gained beyond this share of the volume is told.
inline constexpr double told_share = 0.02;

/// A mesh that a search tries has no more tetrahedra than these.
inline constexpr double most_searched_tets = 1e7;

/// Cells of lattices that a search may still try.
struct SearchBudget {
  double cells = 4e8;    ///< in all
  double mixed = 6.4e7;  ///< in blocks that are neither inside nor outside

  /// Takes a lattice away.  Whether it was enough.
  bool pay_for(const PlacedSource& source);
};

/// The volume of a solid.
struct SolidVolume {
  double volume = 0;  ///< world units cubed
  double doubt = 0;   ///< how far it may be off; 0 where there is a formula
  bool exact = false;

  /// Whether it may be the volume of the mesh, but for the share that is not told.
  [[nodiscard]] bool may_be(double mesh_volume) const;
  /// Whether it is, as far as one can know.
  [[nodiscard]] bool surely_is(double mesh_volume) const;
};

/// Exact where the source knows it, and otherwise estimated, at less cost than a mesh.
SolidVolume volume_of(const PlacedSource& source, const Context& context);

/// Of a counted mesh, in world units cubed.
double measured_volume(const Stuffing& stuffing, const Frame& frame, Context& context);

/// A mesh at a size that was tried.
struct KeptSize {
  double size = 0, share = 0;  ///< share: of the solid's volume
  std::uint64_t tets = 0;
};

/// Counts and measures meshes at smaller and smaller sizes.
class KeepingSize {
 public:
  /// `count_at` gives a counted mesh, or nothing where the mesh is too large or the budget
  /// too small.
  using CountAt = std::function<std::optional<Counted>(double size, SearchBudget& budget)>;

  KeepingSize(CountAt count_at, double thin, Context& context)
      : count_at_(std::move(count_at)), thin_(thin), context_(context) {}

  /// The first below this size whose mesh keeps the volume; `thin` lets it begin
  /// where something may be kept at all.
  std::optional<KeptSize> find(double below);
  /// The smallest that was tried, whose share may be 0; of size 0 if none was.
  [[nodiscard]] const KeptSize& finest() const { return finest_; }

 private:
  CountAt count_at_;
  double thin_;
  Context& context_;
  KeptSize finest_;
};

/// As the end of a sentence: a size that keeps the solid, or that none was found.  `thin`
/// is how thick its thin parts are, or 0.
std::string advice(const std::optional<KeptSize>& kept, const KeptSize& finest,
                   double thin);

}  // namespace certet::command
