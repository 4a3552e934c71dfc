// Stands in for files/hdf5/.

#include "parts/hdf5.hpp"

#include "parts/part.hpp"

namespace certet {

bool has_hdf5() { return true; }

namespace formats {

std::unique_ptr<MeshWriter> open_xdmf(const std::filesystem::path& file, const MeshSize& size) {
  return command::part<command::Hdf5Part>().open_xdmf(file, size);
}
std::unique_ptr<MeshWriter> open_vtkhdf(const std::filesystem::path& file, const MeshSize& size) {
  return command::part<command::Hdf5Part>().open_vtkhdf(file, size);
}
std::uint64_t xdmf_bytes(const MeshSize& size) {
  return command::part<command::Hdf5Part>().xdmf_bytes(size);
}
std::uint64_t vtkhdf_bytes(const MeshSize& size) {
  return command::part<command::Hdf5Part>().vtkhdf_bytes(size);
}

}  // namespace formats
}  // namespace certet
