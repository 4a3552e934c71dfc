#include "kept_volume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "certet/error.hpp"
#include "certet/volume_estimate.hpp"
#include "certet/write_mesh.hpp"
#include "table.hpp"

namespace certet::command {
namespace {

/// Takes a mesh that is only measured.
class Nowhere final : public MeshWriter {
 public:
  void points(std::span<const Point3>) override {}
  void tets(std::span<const Tet<std::uint32_t>>, std::span<const std::int32_t>) override {}
  void tets(std::span<const Tet<std::uint64_t>>, std::span<const std::int32_t>) override {}
  void finish() override {}
};

}  // namespace

double measured_volume(const Stuffing& stuffing, const Frame& frame, Context& context) {
  constexpr std::uint64_t slab_bytes = 24 << 20;
  if (stuffing.tet_count() == 0) return 0;
  Nowhere nowhere;
  return write_mesh(stuffing, frame, cut_slabs(stuffing, slab_bytes), nowhere, context)
      .world.volume;
}

bool SearchBudget::pay_for(const PlacedSource& source) {
  constexpr std::int32_t side = 32;  // lattice units
  const auto& cells = source.lattice.cells;
  this->cells -= 1.0 * cells[0] * cells[1] * cells[2];
  if (this->cells < 0) return false;
  const Coord3 low = source.lattice.origin;
  for (std::int32_t z = 0; z < 2 * cells[2]; z += side)
    for (std::int32_t y = 0; y < 2 * cells[1]; y += side)
      for (std::int32_t x = 0; x < 2 * cells[0] && mixed >= 0; x += side) {
        const Coord3 high{std::min(x + side, 2 * cells[0]), std::min(y + side, 2 * cells[1]),
                          std::min(z + side, 2 * cells[2])};
        if (source.domain->extent({low + Coord3{x, y, z}, low + high}) == Extent::mixed)
          mixed -= 0.125 * (high.x - x) * (high.y - y) * (high.z - z);
      }
  return mixed >= 0;
}

bool SolidVolume::may_be(double mesh_volume) const {
  return std::fabs(mesh_volume - volume) <= told_share * volume + doubt;
}

bool SolidVolume::surely_is(double mesh_volume) const {
  return may_be(mesh_volume) && doubt <= told_share * volume;
}

SolidVolume volume_of(const PlacedSource& source, const Context& context) {
  if (source.volume) return {*source.volume, 0, true};
  // As many points as a quarter of the lattice's.
  const auto& cells = source.lattice.cells;
  const double points = 0.5 * cells[0] * cells[1] * cells[2];
  const auto samples = static_cast<std::uint64_t>(std::clamp(points, 2e5, 2e6));
  const VolumeEstimate found =
      estimate_volume(*source.domain, source.lattice, source.frame, samples, context);
  return {found.volume, 3 * found.deviation, false};
}

std::optional<KeptSize> KeepingSize::find(double below) {
  constexpr double finer = 1.5;
  constexpr int most_tries = 14;
  SearchBudget budget;
  double size = below / finer;
  if (thin_ > 0) size = std::min(size, thin_ / finer);
  try {
    for (int n = 0; n < most_tries; ++n, size /= finer) {
      const std::optional<Counted> counted = count_at_(size, budget);
      if (!counted) break;
      finest_ = {size, 0, counted->stuffing.tet_count()};
      const double mesh = measured_volume(counted->stuffing, counted->source.frame, context_);
      if (mesh == 0) continue;
      const SolidVolume solid = volume_of(counted->source, context_);
      if (solid.volume > 0) finest_.share = mesh / solid.volume;
      if (solid.surely_is(mesh)) return finest_;
    }
  } catch (const Error& error) {
    if (error.code() != ErrorCode::too_large) throw;
  }
  return std::nullopt;
}

std::string advice(const std::optional<KeptSize>& kept, const KeptSize& finest, double thin) {
  if (kept)
    return fmt::format("--size {:.6g} has {:.1f} % of it, in {} tetrahedra", kept->size,
                       100 * kept->share, grouped(kept->tets));
  const std::string parts =
      thin > 0 ? fmt::format("parts of it are {:.3g} thick, and ", thin) : std::string();
  if (finest.size == 0) return parts + "smaller sizes would take too many tetrahedra to try";
  if (finest.share == 0)
    return parts + fmt::format("no size down to {:.4g} keeps any of it", finest.size);
  return parts + fmt::format("--size {:.6g}, the smallest that was tried, has {:.1f} % of it, in "
                             "{} tetrahedra",
                             finest.size, 100 * finest.share, grouped(finest.tets));
}

}  // namespace certet::command
