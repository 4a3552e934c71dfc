#pragma once
/// \file
/// What `certet mesh --json` told of the run that made a mesh, and whether a file
/// holds that mesh.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "certet/formats.hpp"
#include "certet/page.hpp"

namespace certet::command {

/// What is known of a run.
struct RunFile {
  std::filesystem::path file;
  std::uint64_t points = 0, tets = 0;  ///< of the mesh that it made
  std::uint64_t file_checksum = 0;     ///< of what its output holds
  AngleBounds bounds{};                ///< of the theorem that covers that
  double edge = 0;                     ///< the long edge, in the coordinates of its output
  std::vector<PageRow> rows;           ///< what a page says of it
};

/// \throws Error `bad_input` if it is not the JSON of a finished `certet mesh`, tells no
/// checksum of the output, or names another theorem or other bounds than such a run has.
RunFile read_run(const std::filesystem::path& file);

/// Whether a file holds, bit by bit, the points and tetrahedra that the run wrote: a
/// sentence if it does not, else empty.  `checksum` is that of the mesh in the file.
/// \throws Error `bad_input` if even their numbers are others: the run is of another mesh.
std::string content_defect(const RunFile& run, const std::filesystem::path& file,
                           const FileMesh& mesh, std::uint64_t checksum);

}  // namespace certet::command
