#include "run_file.hpp"

#include "reader.hpp"
#include "targets.hpp"

namespace fuzz {

void run_file(Bytes bytes) {
  const InputFile file(bytes, ".json");
  read_or_refuse([&] { certet::command::read_run(file.path()); });
}

}  // namespace fuzz
