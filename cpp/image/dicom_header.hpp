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
  std::uint64_t rows = 0, columns = 0, bits = 0, samples = 1;

  /// Whether there is as much as the header announces, as far as this is known.
  [[nodiscard]] bool holds_voxels() const {
    return packed || pixel_bytes >= rows * columns * samples * (bits / 8);
  }
};

/// Nothing for a file whose elements do not fit into each other and the file, or
/// whose transfer syntax is big-endian or deflated.
std::optional<DicomHeader> read_dicom_header(const std::filesystem::path& file);

}  // namespace certet
