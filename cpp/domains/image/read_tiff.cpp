// The voxels of a TIFF file.  By libtiff and not through ITK, whose reader takes
// it for granted that all pages are like the first.

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

#include "geometry.hpp"
#include "image_file.hpp"
#include "tiff_pages.hpp"
#include "volumes.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

/// What is known of packed voxels: how much they can have shrunk at most.
void check_length(const fs::path& file, TIFF* tiff, std::uint64_t bytes) {
  std::uint16_t packing = COMPRESSION_NONE;
  TIFFGetFieldDefaulted(tiff, TIFFTAG_COMPRESSION, &packing);
  const bool known = packing == COMPRESSION_NONE || packing == COMPRESSION_LZW ||
                     packing == COMPRESSION_ADOBE_DEFLATE || packing == COMPRESSION_DEFLATE ||
                     packing == COMPRESSION_PACKBITS;
  const std::uint64_t greatest_ratio = packing == COMPRESSION_NONE ? 1 : 1400;
  if (known && bytes / greatest_ratio > fs::file_size(file))
    refuse(file, "is too short for the dimensions in its header");
}

/// `to` has the rows of a page as they are stored.
bool read_strips(TIFF* tiff, const TiffPage& page, char* to) {
  const std::uint64_t row = page.row_bytes();
  std::uint32_t rows = page.height;
  TIFFGetFieldDefaulted(tiff, TIFFTAG_ROWSPERSTRIP, &rows);
  if (rows == 0) return false;
  std::uint32_t strip = 0;
  for (std::uint64_t y = 0; y < page.height; y += rows, ++strip) {
    const std::uint64_t bytes = row * std::min<std::uint64_t>(rows, page.height - y);
    const auto wanted = static_cast<tmsize_t>(bytes);
    if (TIFFReadEncodedStrip(tiff, strip, to + y * row, wanted) != wanted) return false;
  }
  return true;
}

/// A tile is a multiple of 16 voxels wide, so that its rows are whole bytes.
bool read_tiles(TIFF* tiff, const TiffPage& page, char* to) {
  std::uint32_t width = 0, height = 0;
  TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &width);
  TIFFGetField(tiff, TIFFTAG_TILELENGTH, &height);
  const tmsize_t bytes = TIFFTileSize(tiff);
  const std::uint64_t tile_row = std::uint64_t{width} * page.bits / 8;
  if (width == 0 || height == 0 || bytes <= 0 || width > page.width + 65536U ||
      height > page.height + 65536U || width * page.bits % 8 != 0 ||
      tile_row * height != static_cast<std::uint64_t>(bytes))
    return false;
  std::vector<char> tile(static_cast<std::size_t>(bytes));
  for (std::uint32_t y = 0; y < page.height; y += height)
    for (std::uint32_t x = 0; x < page.width; x += width) {
      if (TIFFReadTile(tiff, tile.data(), x, y, 0, 0) != bytes) return false;
      const std::uint64_t begin = std::uint64_t{x} * page.bits / 8;
      const std::uint64_t count = std::min(tile_row, page.row_bytes() - begin);
      for (std::uint32_t r = 0; r < std::min(height, page.height - y); ++r)
        std::memcpy(to + (std::uint64_t{y} + r) * page.row_bytes() + begin,
                    tile.data() + r * tile_row, count);
    }
  return true;
}

/// The page that is open; `number` counts from 0.
void read_page(const fs::path& file, TIFF* tiff, const TiffPage& page, std::uint32_t number,
               char* to) {
  if (number > 0 && (TIFFReadDirectory(tiff) != 1 || page_of(tiff) != page))
    refuse(file, "has changed");
  const bool whole = TIFFIsTiled(tiff) ? read_tiles(tiff, page, to) : read_strips(tiff, page, to);
  if (!whole) refuse(file, "is truncated or damaged");
}

template <class T>
Buffer<T> load(const fs::path& file, TIFF* tiff, const TiffPage& page, std::uint32_t pages) {
  Buffer<T> voxels(page.voxels() * pages);
  char* to = reinterpret_cast<char*>(voxels.data());
  for (std::uint32_t number = 0; number < pages; ++number, to += page.bytes())
    read_page(file, tiff, page, number, to);
  return voxels;
}

/// Voxels of 1, 2 or 4 bits, the first in the highest bits of a byte.
Buffer<std::uint8_t> load_bits(const fs::path& file, TIFF* tiff, const TiffPage& page,
                               std::uint32_t pages) {
  Buffer<std::uint8_t> voxels(page.voxels() * pages);
  std::vector<char> stored(page.bytes());
  const std::uint64_t in_byte = 8U / page.bits;
  std::uint8_t* to = voxels.data();
  for (std::uint32_t number = 0; number < pages; ++number) {
    read_page(file, tiff, page, number, stored.data());
    for (std::uint64_t y = 0; y < page.height; ++y)
      for (std::uint64_t x = 0; x < page.width; ++x) {
        const auto byte = static_cast<unsigned char>(stored[y * page.row_bytes() + x / in_byte]);
        const auto shift = (in_byte - 1 - x % in_byte) * page.bits;
        *to++ = static_cast<std::uint8_t>(byte >> shift & ((1U << page.bits) - 1));
      }
  }
  return voxels;
}

Voxels load_voxels(const fs::path& file, TIFF* tiff, const TiffPage& page, std::uint32_t pages) {
  if (page.bits < 8 && page.format != SAMPLEFORMAT_UINT && page.format != SAMPLEFORMAT_VOID)
    refuse(file, "has voxels of a type that is not supported");
  if (page.bits < 8) return load_bits(file, tiff, page, pages);
  const auto as = [&]<class T>(T) { return Voxels(load<T>(file, tiff, page, pages)); };
  switch (page.format * 100 + page.bits) {
    case SAMPLEFORMAT_VOID * 100 + 8:
    case SAMPLEFORMAT_UINT * 100 + 8: return as(std::uint8_t{});
    case SAMPLEFORMAT_VOID * 100 + 16:
    case SAMPLEFORMAT_UINT * 100 + 16: return as(std::uint16_t{});
    case SAMPLEFORMAT_UINT * 100 + 32: return as(std::uint32_t{});
    case SAMPLEFORMAT_INT * 100 + 8: return as(std::int8_t{});
    case SAMPLEFORMAT_INT * 100 + 16: return as(std::int16_t{});
    case SAMPLEFORMAT_INT * 100 + 32: return as(std::int32_t{});
    case SAMPLEFORMAT_IEEEFP * 100 + 32: return as(float{});
    case SAMPLEFORMAT_IEEEFP * 100 + 64: return as(double{});
    default: refuse(file, "has voxels of a type that is not supported");
  }
}

}  // namespace

Image read_tiff(const fs::path& file, std::uint64_t max_bytes, const ImageChoice& choice) {
  const Tiff tiff = open_tiff(file);
  TiffPage page;
  const std::uint32_t pages = check_pages(file, tiff.get(), page);
  chosen_volume(file, 1, "", choice.volume);
  if (page.voxels() > std::numeric_limits<std::int64_t>::max() / pages / 8)
    refuse(file, "has impossible dimensions");
  const std::uint64_t bytes = page.bytes() * pages;
  check_length(file, tiff.get(), bytes);
  check_memory(file, std::max(bytes, page.voxels() * pages), max_bytes);
  Image image;
  image.name = file.string();
  image.size = {page.width, page.height, pages};
  const TiffSpacing found = spacing_of(file, tiff.get(), pages);
  image.spacing = found.spacing;
  if (!choice.spacing) image.notes.push_back(found.note);
  if (page.zero_is_white)
    image.notes.push_back("the file shows its zeros white; its numbers are taken as they are stored, "
                          "and --labels 0 takes the zeros");
  check_geometry(image);
  image.voxels = load_voxels(file, tiff.get(), page, pages);
  return image;
}

}  // namespace certet
