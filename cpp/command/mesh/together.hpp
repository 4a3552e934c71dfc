#pragma once
/// \file
/// A mesh that several processes make together, each with a share of its layers.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "certet/ranks.hpp"
#include "certet/shared_file.hpp"
#include "certet/stuffing.hpp"
#include "mesh_options.hpp"
#include "source.hpp"

namespace certet::command {

/// What the command has of those who run it together.
struct Together {
  Ranks& ranks;
  int on_this_machine;  ///< ranks, this one among them
  /// The file of so many bytes that all ranks write; all of them call it.
  std::function<std::unique_ptr<SharedFile>(const std::filesystem::path&, std::uint64_t bytes)>
      create;

  [[nodiscard]] bool is_first() const { return ranks.rank() == 0; }
};

/// What a rank had of a run.
struct RankReport {
  std::int32_t layers;
  std::uint64_t points, tets;
  std::uint64_t memory_peak;
  double seconds;  ///< of its processors, all threads together
};

/// Refuses what several processes cannot do yet.  \throws Error `bad_option`.
void refuse_alone(const MeshOptions& options);

/// The mesh of a source, or this rank's share of it.  Where pieces are dropped or cells joined,
/// which looks at the whole, each rank has all layers: `share_out` then tells who writes which.
Stuffing stuffed(const MeshOptions& options, const PlacedSource& placed, Context& context);
void share_out(const MeshOptions& options, Stuffing& stuffing);

/// What writes the mesh, or this rank's part of it.
std::unique_ptr<MeshWriter> open_mesh(const MeshOptions& options, const Stuffing& stuffing,
                                      const MeshSize& size);

/// The memory for a lattice where each rank may use so much: those that share it have more.
std::uint64_t lattice_limit(const MeshOptions& options, std::uint64_t limit);

/// The least of the limits of all ranks, of which those of one machine have equal parts.
std::uint64_t shared_memory_limit(const Together& together, std::uint64_t limit, bool was_asked);

/// Of one rank, where `asked` is 0: those of its machine share the processors.
int threads_of(const Together& together, int asked);

/// Of all ranks.
std::vector<RankReport> rank_reports(const Together& together, const Stuffing& stuffing,
                                     std::uint64_t memory_peak);

}  // namespace certet::command
