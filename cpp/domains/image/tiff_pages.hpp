#pragma once
/// \file
/// The pages of a TIFF file, and what they say of the size of a voxel.

#include <tiffio.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "certet/image.hpp"

namespace certet {

using Tiff = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

/// An open file that keeps its warnings to itself.
/// \throws Error `bad_input` where it is no TIFF file.
Tiff open_tiff(const std::filesystem::path& file);

/// What all pages must share.
struct TiffPage {
  std::uint32_t width = 0, height = 0;
  std::uint16_t bits = 1, samples = 1, format = SAMPLEFORMAT_UINT, orientation = 1;
  bool zero_is_white = false;
  bool operator==(const TiffPage&) const = default;

  /// As stored, each row in whole bytes.
  [[nodiscard]] std::uint64_t row_bytes() const { return (std::uint64_t{width} * bits + 7) / 8; }
  [[nodiscard]] std::uint64_t bytes() const { return row_bytes() * height; }
  [[nodiscard]] std::uint64_t voxels() const { return std::uint64_t{width} * height; }
};

/// Of the page that is open.
TiffPage page_of(TIFF* tiff);

/// Goes through all pages, counts them, and returns to the first.
/// \throws Error `bad_input` where they differ or are not one number per voxel.
std::uint32_t check_pages(const std::filesystem::path& file, TIFF* tiff, TiffPage& first);

/// Size of a voxel by the tags of the first page, in millimetres where they name a
/// unit, and a sentence that says so.
struct TiffSpacing {
  Point3 spacing{1, 1, 1};
  std::string note;
};
/// \throws Error `bad_input` where the file says that pages are channels or times.
TiffSpacing spacing_of(const std::filesystem::path& file, TIFF* tiff, std::uint32_t pages);

}  // namespace certet
