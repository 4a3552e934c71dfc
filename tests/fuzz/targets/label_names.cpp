#include "certet/label_names.hpp"

#include "reader.hpp"
#include "targets.hpp"

namespace fuzz {

void label_names(Bytes bytes) {
  const InputFile file(bytes, ".txt");
  read_or_refuse([&] {
    for (const auto& [label, name] : certet::read_label_names(file.path()))
      if (name.empty()) throw Finding("label " + std::to_string(label) + " has an empty name");
  });
}

}  // namespace fuzz
