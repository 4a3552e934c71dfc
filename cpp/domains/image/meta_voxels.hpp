#pragma once
/// \file
/// Where the voxels of a MetaImage are.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "meta_header.hpp"
#include "number_type.hpp"
#include "stored_voxels.hpp"

namespace certet {

struct MetaVoxels {
  std::vector<StoredPart> parts;  ///< one after the other
  bool text = false;              ///< numbers with blanks between them
  bool swapped = false;           ///< the other byte order
};

/// `bytes` are those of all voxels, `size` is along all dimensions.  The size that the
/// header tells of packed voxels is not looked at: they end where they end.
/// \throws Error `bad_input` where a file that the header names is missing.
MetaVoxels meta_voxels(const std::filesystem::path& file, const MetaHeader& header,
                       std::uint64_t bytes, const std::vector<std::uint64_t>& size);

/// Writes that many numbers.  \throws Error `bad_input` where they are not all there.
void read_meta_voxels(const std::filesystem::path& file, const MetaVoxels& voxels,
                      NumberType type, std::uint64_t count, char* to);

}  // namespace certet
