#pragma once
/// \file
/// What the readers of images have in common.

#include <cstdint>
#include <filesystem>
#include <string>

#include "certet/error.hpp"
#include "certet/image.hpp"
#include "domains/refused_file.hpp"

namespace certet {

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

/// Reads one kind of file whose voxels need no more than `max_bytes`; but for TIFF it may
/// throw itk::ExceptionObject too, where the file is damaged.
using ReadImage = Image(const std::filesystem::path& file, std::uint64_t max_bytes,
                        const ImageChoice& choice);

/// The pages of a TIFF file, by libtiff itself.  Voxels have the size that an
/// ImageJ stack tells or, where a resolution alone is there, are cubes of it; else
/// they are 1 x 1 x 1, and a note says what was taken unless a spacing was chosen.
ReadImage read_tiff;

ReadImage read_nifti, read_nrrd, read_meta;

/// A series in a folder: the one chosen or the only one.
ReadImage read_dicom;
/// One file, which must be of several frames or a segmentation.
ReadImage read_dicom_file;
/// The same for a file whose header was checked well.
ReadImage read_dicom_frames;

}  // namespace certet
