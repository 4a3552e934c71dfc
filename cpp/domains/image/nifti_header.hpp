#pragma once
/// \file
/// What a NIfTI file says of itself: versions 1 and 2, and ANALYZE 7.5 before them.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "certet/image.hpp"
#include "number_type.hpp"
#include "stored_voxels.hpp"

namespace certet {

/// A step along each voxel axis and the centre of the first voxel, in millimetres
/// where the file names a unit; x to the right, y to the front, z to the head.
struct NiftiPlace {
  std::array<std::array<double, 4>, 3> rows{};  ///< of the affine matrix
};

/// A header in which nothing is impossible.
struct NiftiHeader {
  int version = 1;  ///< 0 for ANALYZE
  bool swapped = false;  ///< the other byte order
  std::array<std::int64_t, 3> size{1, 1, 1};
  std::uint64_t volumes = 1;
  NumberType type{};
  double slope = 1, intercept = 0;  ///< of the values, by what is stored
  std::array<double, 3> spacing{1, 1, 1};
  std::optional<NiftiPlace> qform, sform;  ///< where their code is set
  double unit = 1;                         ///< in millimetres; all lengths have it already
  std::uint64_t offset = 0;                ///< of the voxels, in their file
  std::filesystem::path voxel_file;
};

/// Whether a file, or the .hdr file that belongs to an .img file, begins as NIfTI or
/// ANALYZE does.
bool is_nifti(const std::filesystem::path& file);

/// \throws Error `bad_input`, the sentence names the file; also where numbers are not
///   finite, or beyond 10^12, that place the voxels.
NiftiHeader read_nifti_header(const std::filesystem::path& file);

}  // namespace certet
