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

[[noreturn]] inline void refuse_dicom(const std::filesystem::path& file) {
  refuse(file, "is truncated or damaged, or of a kind of DICOM that is not supported");
}

/// \throws Error `too_large`
inline void check_memory(const std::filesystem::path& file, std::uint64_t bytes,
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
/// they are 1 x 1 x 1, and a note says what was taken unless a spacing was chosen.
Image read_tiff(const std::filesystem::path& file, std::uint64_t max_bytes,
                const ImageChoice& choice);

/// The others may throw itk::ExceptionObject too, for damaged files.
Image read_nifti(const std::filesystem::path& file, std::uint64_t max_bytes,
                 const ImageChoice& choice);
Image read_nrrd(const std::filesystem::path& file, std::uint64_t max_bytes,
                const ImageChoice& choice);
Image read_meta(const std::filesystem::path& file, std::uint64_t max_bytes,
                const ImageChoice& choice);

/// A series in a folder: the one chosen or the only one.
Image read_dicom(const std::filesystem::path& folder, std::uint64_t max_bytes,
                 const ImageChoice& choice);
/// One file, which must be of several frames or a segmentation.
Image read_dicom_file(const std::filesystem::path& file, std::uint64_t max_bytes,
                      const ImageChoice& choice);
/// The same for a file whose header was checked well.
Image read_dicom_frames(const std::filesystem::path& file, std::uint64_t max_bytes,
                        const ImageChoice& choice);

}  // namespace certet
