#pragma once
/// \file
/// Where in a file the voxels are.

#include <cstdint>
#include <filesystem>
#include <optional>

namespace certet {

/// The voxels follow `offset` bytes of the file and, once unpacked, `lead` more.
struct StoredVoxels {
  std::filesystem::path file;
  std::uint64_t offset = 0;
  std::uint64_t lead = 0;
  bool packed = false;  ///< by gzip or zlib
};

/// Nothing where the header does not say it plainly: voxels in several files, as
/// text, or in an encoding of another kind.
std::optional<StoredVoxels> stored_voxels(const std::filesystem::path& file);

}  // namespace certet
