// Stands in for files/hdf5/.

#include "parts/hdf5.hpp"

#include "parts/part.hpp"

namespace certet {
namespace {

const command::Hdf5Part& hdf5() {
  return command::part<command::Hdf5Part>("certet-hdf5");
}

}  // namespace

bool has_hdf5() { return true; }

namespace formats {

std::unique_ptr<MeshWriter> open_xdmf(const std::filesystem::path& file, const MeshSize& size) {
  return hdf5().open_xdmf(file, size);
}
std::unique_ptr<MeshWriter> open_vtkhdf(const std::filesystem::path& file, const MeshSize& size) {
  return hdf5().open_vtkhdf(file, size);
}
std::uint64_t xdmf_bytes(const MeshSize& size) { return hdf5().xdmf_bytes(size); }
std::uint64_t vtkhdf_bytes(const MeshSize& size) { return hdf5().vtkhdf_bytes(size); }

}  // namespace formats
}  // namespace certet
