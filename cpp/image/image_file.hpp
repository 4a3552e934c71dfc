#pragma once
/// \file
/// What the readers of images have in common.

#include <cstdint>
#include <filesystem>
#include <string>

#include "certet/error.hpp"
#include "certet/image.hpp"

namespace certet {

[[noreturn]] inline void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw Error(ErrorCode::bad_input, "'" + file.string() + "' " + reason);
}

/// \throws Error `too_large`
inline void judge_memory(const std::filesystem::path& file, std::uint64_t bytes,
                         std::uint64_t max_bytes) {
  if (bytes > max_bytes)
    throw Error(ErrorCode::too_large, "the voxels of '" + file.string() + "' need " +
                                          std::to_string(bytes) + " bytes, more than the " +
                                          std::to_string(max_bytes) + " allowed");
}

/// By the first bytes of a file.
bool is_tiff(const std::filesystem::path& file);
bool is_dicom(const std::filesystem::path& file);

/// The pages of a TIFF file, by libtiff itself.  Voxels have the size that an
/// ImageJ stack tells or, where a resolution alone is there, are cubes of it; else
/// they are 1 x 1 x 1.  `tell` notes what was taken.
Image read_tiff(const std::filesystem::path& file, std::uint64_t max_bytes, bool tell);

/// A series in a folder, by its UID or, where that is empty, the only one.
/// \throws itk::ExceptionObject too, for damaged files.
Image read_dicom(const std::filesystem::path& folder, std::uint64_t max_bytes,
                 const std::string& series);

}  // namespace certet
