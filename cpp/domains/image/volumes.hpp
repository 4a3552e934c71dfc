#pragma once
/// \file
/// How many voxels there are, and which of several volumes in a file.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace certet {

/// \returns the number of voxels.  \throws Error `bad_input` where there are none or
/// their bytes are beyond counting.
std::uint64_t check_count(const std::filesystem::path& file,
                          const std::array<std::int64_t, 3>& size, std::size_t bytes_of_one);

/// The number, from 0, of the volume that is read from a file of `count`.  `what` it
/// has goes into the sentence: so many volumes, or numbers per voxel.
/// \throws Error `bad_input` where there are several and none was chosen, naming the
/// option; `bad_option` where there is no such one.
std::uint64_t chosen_volume(const std::filesystem::path& file, std::uint64_t count,
                            const std::string& what, std::optional<std::uint64_t> chosen);

}  // namespace certet
