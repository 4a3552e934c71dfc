// Stands in for write_png.cpp where libpng was left out.

#include "certet/error.hpp"
#include "certet/picture.hpp"

namespace certet {

bool can_write_png() { return false; }

void write_png(const Picture&, const std::filesystem::path& file) {
  throw Error(ErrorCode::write_failed,
              "cannot write '" + file.string() + "': writing PNG was not built in");
}

}  // namespace certet
