#pragma once
/// \file
/// How much memory a run may use, and how a mesh is cut so that it fits.

#include <cstdint>

#include "certet/write_mesh.hpp"
#include "counted.hpp"
#include "mesh_options.hpp"
#include "mesh_report.hpp"

namespace certet::command {

/// What the process needs besides voxels, lattice and slabs.
inline constexpr std::uint64_t base_bytes = 256 << 20;

/// As the options say, or by what is free.
std::uint64_t memory_limit(const MeshOptions& options);

/// \throws Error `too_large` where a mesh of so many tetrahedra cannot fit.
void check_target(const MeshOptions& options, std::uint64_t limit);

/// \throws Error `too_large` where the engine's lattice does not fit.
void check_lattice(const PlacedSource& source, Method method, std::uint64_t limit);

/// Whether the mesh can be held while its vertices move.
bool can_move(const Counted& counted, const MeshReport& report);
/// \throws Error `too_large` where it cannot; `what` needs it.
void check_moving_memory(const Counted& counted, const std::string& what,
                         const MeshReport& report);

/// Chooses the slabs by the memory that the writer of a format leaves.  \throws Error `too_large`.
Slabs plan(const Counted& counted, const MeshSize& size, Format format, MeshReport& report);

}  // namespace certet::command
