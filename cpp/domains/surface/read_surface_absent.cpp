// Stands in for read_surface.cpp where assimp was left out.

#include "certet/error.hpp"
#include "certet/surface.hpp"

namespace certet {

bool can_read_surfaces() { return false; }

TriangleSurface read_surface(const std::filesystem::path& file) {
  throw Error(ErrorCode::bad_input,
              "'" + file.string() + "' cannot be read: reading surfaces was not built in");
}

}  // namespace certet
