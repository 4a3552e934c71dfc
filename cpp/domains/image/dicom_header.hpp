#pragma once
/// \file
/// Whether a DICOM file is whole.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace certet {

/// What is read without GDCM, which ends the program where an element reaches
/// beyond the file, and fills with zeros what is missing of the voxels.
struct DicomHeader {
  std::string series;             ///< UID; empty where there is none
  std::uint64_t pixel_bytes = 0;  ///< of voxels that are not packed
  bool packed = false;
  std::string kind;               ///< UID of the SOP class
  std::string photometric;        ///< interpretation; empty where it is not told
  std::uint64_t rows = 0, columns = 0, samples = 1, frames = 1;
  bool counts_frames = false, tells_increment = false;
  std::uint64_t bits = 0, bits_stored = 0, high_bit = 0, is_signed = 0;

  /// Whether there is as much as the header announces, as far as this is known,
  /// and of a kind that numbers have.  Reports have no voxels, and are whole.
  [[nodiscard]] bool holds_voxels() const;
  [[nodiscard]] bool is_segmentation() const;
  /// Of palettes GDCM wants tables, or ends the program.
  [[nodiscard]] bool is_gray() const {
    return photometric.empty() || photometric == "MONOCHROME1" || photometric == "MONOCHROME2";
  }
  /// Whether it is more than one slice of a series: several frames, or segments; or
  /// says by what its frames differ but not how many they are, of which ITK's reader
  /// would die.
  [[nodiscard]] bool holds_frames() const {
    return frames > 1 || is_segmentation() || (tells_increment && !counts_frames);
  }
};

/// Nothing for a file whose elements do not fit into each other and the file.
/// \throws Error `bad_input` for a transfer syntax that is big-endian, deflated or not
/// known.
std::optional<DicomHeader> read_dicom_header(const std::filesystem::path& file);

}  // namespace certet
