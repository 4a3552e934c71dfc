// An OpenVDB file; its masks are mostly zeros, which the input has packed: a zero is
// followed by how many more there are.

#include "certet/volume.hpp"

#include <vector>

#include "reader.hpp"
#include "targets.hpp"

namespace fuzz {
namespace {

std::vector<std::uint8_t> with_zeros(Bytes bytes) {
  std::vector<std::uint8_t> file;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    file.push_back(bytes[i]);
    if (bytes[i] == 0 && ++i < bytes.size()) file.insert(file.end(), bytes[i], 0);
  }
  return file;
}

void place(const certet::Volume& volume, std::optional<double> level) {
  read_or_refuse([&] {
    const auto domain = certet::volume_domain(volume, level, {});
    std::array<certet::Sign, 8> signs;
    domain->row(domain->lattice().origin, signs);
    domain->row({0, 0, 0}, signs);
    static_cast<void>(domain->extent({{0, 0, 0}, {4, 4, 4}}));
  });
}

}  // namespace

void volume(Bytes bytes) {
  const InputFile file(with_zeros(bytes), ".vdb");
  for (const char* const grid : {"", "thick"}) read_or_refuse([&] {
    const certet::Volume volume = certet::read_volume(file.path(), grid);
    place(volume, {});
    place(volume, 0.5);
  });
}

}  // namespace fuzz
