#pragma once
/// \file
/// What `certet mesh --json` told of the run that made a mesh.

#include <cstdint>
#include <filesystem>

#include "certet/page.hpp"

namespace certet::command {

/// What a page says of a run.
struct RunFile {
  std::uint64_t points = 0, tets = 0;  ///< of the mesh that it made
  std::vector<PageRow> rows;
  AngleBounds bounds{};
  std::string theorem;  ///< what bounds.theorem looks at
};

/// \throws Error `bad_input` if it is not the JSON of a finished `certet mesh`.
RunFile read_run(const std::filesystem::path& file);

}  // namespace certet::command
