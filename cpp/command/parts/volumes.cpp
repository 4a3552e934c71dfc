// Stands in for those files of domains/volume/ that need OpenVDB.

#include "parts/volumes.hpp"

#include "parts/part.hpp"

namespace certet {

bool can_read_volumes() { return true; }

Volume read_volume(const std::filesystem::path& file, const std::string& grid) {
  return command::part<command::VolumesPart>().read_volume(file, grid);
}

std::unique_ptr<PlacedDomain> volume_domain(const Volume& volume, std::optional<double> level,
                                            const VolumeLattice& lattice) {
  return command::part<command::VolumesPart>().volume_domain(volume, level, lattice);
}

Solid volume_solid(const Volume& volume, std::optional<double> level) {
  return command::part<command::VolumesPart>().volume_solid(volume, level);
}

}  // namespace certet
