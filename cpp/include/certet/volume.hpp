#pragma once
/// \file
/// Sparse volumes, as OpenVDB has them, and the solids in them.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "certet/placed_domain.hpp"
#include "certet/solid.hpp"

namespace certet {

/// A scalar grid of a file; copies share it.
class Volume {
 public:
  struct State;
  explicit Volume(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  [[nodiscard]] const State& state() const { return *state_; }
  [[nodiscard]] const std::shared_ptr<const State>& shared() const { return state_; }

 private:
  std::shared_ptr<const State> state_;
};

/// Whether volumes were built in.
bool can_read_volumes();

/// Whether the extension is .vdb.
bool is_volume_file(const std::filesystem::path& file);

/// Reads a grid of real numbers from a .vdb file.  `grid` names it; without a
/// name it is the first level set, by name, or, if there is none, the only
/// grid of real numbers.
/// \throws Error `bad_input` where the file is missing, damaged, has no such grid
/// or several to choose from, or a transform that is not affine.
Volume read_volume(const std::filesystem::path& file, const std::string& grid);

/// How finely a volume is meshed.
struct VolumeLattice {
  double size = 0;  ///< long edge in world units; 0: the smallest side of a voxel
  std::int32_t margin = 2;  ///< lattice cells around the active voxels, at least 1
};

/// In a level set, where the distance is less than `level` (0 if there is none);
/// in any other grid, where the value is above `level`.  Between voxels the grid
/// is interpolated trilinearly.  The axes are the world's, and the lattice is
/// around the active voxels: what else is inside is cut off there.
/// \throws Error `bad_option` (size, margin, no level where one is needed, a
/// level beyond the narrow band of a level set), `empty_domain` (no active
/// voxels), `too_large` (coordinate range).
std::unique_ptr<PlacedDomain> volume_domain(const Volume& volume, std::optional<double> level,
                                            const VolumeLattice& lattice);

/// The same solid, to be put on a lattice with others.  \throws Error as `volume_domain`.
Solid volume_solid(const Volume& volume, std::optional<double> level);

}  // namespace certet
