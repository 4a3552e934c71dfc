// Stands in for the readers of domains/surface/.

#include "parts/surfaces.hpp"

#include "parts/part.hpp"

namespace certet {

bool can_read_surfaces() { return true; }

TriangleSurface read_surface(const std::filesystem::path& file) {
  return command::part<command::SurfacesPart>().read_surface(file);
}

}  // namespace certet
