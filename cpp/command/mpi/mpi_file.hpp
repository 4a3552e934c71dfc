#pragma once
/// \file
/// One file that the processes of an MPI job write side by side.

#include <cstdint>
#include <filesystem>
#include <memory>

#include "certet/shared_file.hpp"

namespace certet::command {

/// It grows under a hidden name in its folder, as `open_writer` says; all ranks call it.
/// \throws Error `write_failed`.
std::unique_ptr<SharedFile> create_shared(const std::filesystem::path& file, std::uint64_t bytes,
                                          Ranks& ranks);

}  // namespace certet::command
