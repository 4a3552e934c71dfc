// Stands in for write_labels.cpp where ITK was left out.

#include "certet/error.hpp"
#include "certet/voxelise.hpp"

namespace certet {

void write_labels(const Image&, const std::filesystem::path& file) {
  throw Error(ErrorCode::bad_input,
              "'" + file.string() + "' cannot be written: images were not built in");
}

}  // namespace certet
