// Stands in for the other files where OpenVDB was left out.

#include "certet/error.hpp"
#include "certet/volume.hpp"

namespace certet {

struct Volume::State {};

bool can_read_volumes() { return false; }

Volume read_volume(const std::filesystem::path& file, const std::string&) {
  throw Error(ErrorCode::bad_input,
              "'" + file.string() + "' cannot be read: reading volumes was not built in");
}

std::unique_ptr<PlacedDomain> volume_domain(const Volume&, std::optional<double>,
                                            const VolumeLattice&) {
  throw Error(ErrorCode::bad_input, "volumes were not built in");
}

Solid volume_solid(const Volume&, std::optional<double>) {
  throw Error(ErrorCode::bad_input, "volumes were not built in");
}

}  // namespace certet
