#include "certet/volume.hpp"

namespace certet {

bool is_volume_file(const std::filesystem::path& file) { return file.extension() == ".vdb"; }

}  // namespace certet
