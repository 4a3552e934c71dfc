#include <algorithm>

#include "targets/targets.hpp"

namespace fuzz {

const std::vector<Target>& targets() {
  static const std::vector<Target> all{
      {"mesh_file", mesh_file},
      {"convert", convert},
      {"picture", picture},
      {"label_names", label_names},
      {"image", image},
      {"image_parts", image_parts},
      {"dicom", dicom},
      {"volume", volume},
      {"surface", surface},
      {"formula", formula},
      {"core", core},
#ifdef CERTET_FUZZ_COMMAND
      {"options", options},
      {"run_file", run_file},
#endif
      {"planted_reader", planted_reader, true},
      {"planted_memory", planted_memory, true},
      {"planted_core", planted_core, true},
  };
  return all;
}

const Target& target_named(std::string_view name) {
  const auto found = std::ranges::find(targets(), name, &Target::name);
  if (found == targets().end()) throw Finding("there is no target '" + std::string(name) + "'");
  return *found;
}

}  // namespace fuzz
