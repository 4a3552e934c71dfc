// The voxels of a TIFF file.  By libtiff and not through ITK, whose reader takes
// it for granted that all pages are like the first.

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

#include "geometry.hpp"
#include "image_file.hpp"
#include "tiff_pages.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

/// What is known of packed voxels: how much they can have shrunk at most.
void judge_length(const fs::path& file, TIFF* tiff, std::uint64_t bytes) {
  std::uint16_t packing = COMPRESSION_NONE;
  TIFFGetFieldDefaulted(tiff, TIFFTAG_COMPRESSION, &packing);
  const bool known = packing == COMPRESSION_NONE || packing == COMPRESSION_LZW ||
                     packing == COMPRESSION_ADOBE_DEFLATE || packing == COMPRESSION_DEFLATE ||
                     packing == COMPRESSION_PACKBITS;
  const std::uint64_t greatest_ratio = packing == COMPRESSION_NONE ? 1 : 1400;
  if (known && bytes / greatest_ratio > fs::file_size(file))
    refuse(file, "is too short for the dimensions in its header");
}

bool read_strips(TIFF* tiff, const TiffPage& page, char* voxels) {
  const auto row = static_cast<std::uint64_t>(page.width) * page.bits / 8;
  std::uint32_t rows = page.height;
  TIFFGetFieldDefaulted(tiff, TIFFTAG_ROWSPERSTRIP, &rows);
  if (rows == 0) return false;
  std::uint32_t strip = 0;
  for (std::uint64_t y = 0; y < page.height; y += rows, ++strip) {
    const std::uint64_t bytes = row * std::min<std::uint64_t>(rows, page.height - y);
    const auto wanted = static_cast<tmsize_t>(bytes);
    if (TIFFReadEncodedStrip(tiff, strip, voxels + y * row, wanted) != wanted) return false;
  }
  return true;
}

bool read_tiles(TIFF* tiff, const TiffPage& page, char* voxels) {
  const std::uint64_t voxel = page.bits / 8;
  std::uint32_t width = 0, height = 0;
  TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &width);
  TIFFGetField(tiff, TIFFTAG_TILELENGTH, &height);
  const tmsize_t bytes = TIFFTileSize(tiff);
  if (width == 0 || height == 0 || bytes <= 0 || width > page.width + 65536U ||
      height > page.height + 65536U || std::uint64_t{width} * height * voxel !=
                                           static_cast<std::uint64_t>(bytes))
    return false;
  std::vector<char> tile(static_cast<std::size_t>(bytes));
  for (std::uint32_t y = 0; y < page.height; y += height)
    for (std::uint32_t x = 0; x < page.width; x += width) {
      if (TIFFReadTile(tiff, tile.data(), x, y, 0, 0) < 0) return false;
      const std::uint64_t count = std::min(width, page.width - x) * voxel;
      for (std::uint32_t r = 0; r < std::min(height, page.height - y); ++r)
        std::memcpy(voxels + ((std::uint64_t{y} + r) * page.width + x) * voxel,
                    tile.data() + std::uint64_t{r} * width * voxel, count);
    }
  return true;
}

template <class T>
Buffer<T> load(const fs::path& file, TIFF* tiff, const TiffPage& page, std::uint32_t pages) {
  Buffer<T> voxels(page.bytes() * pages / sizeof(T));
  char* to = reinterpret_cast<char*>(voxels.data());
  for (std::uint32_t number = 0; number < pages; ++number, to += page.bytes()) {
    if (number > 0 && (TIFFReadDirectory(tiff) != 1 || page_of(tiff) != page))
      refuse(file, "has changed");
    const bool whole = TIFFIsTiled(tiff) ? read_tiles(tiff, page, to)
                                         : read_strips(tiff, page, to);
    if (!whole) refuse(file, "is truncated or damaged");
  }
  return voxels;
}

Voxels load_voxels(const fs::path& file, TIFF* tiff, const TiffPage& page, std::uint32_t pages) {
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

Image read_tiff(const fs::path& file, std::uint64_t max_bytes, bool tell) {
  const Tiff tiff = open_tiff(file);
  TiffPage page;
  const std::uint32_t pages = judge_pages(file, tiff.get(), page);
  if (page.bytes() > std::numeric_limits<std::int64_t>::max() / pages)
    refuse(file, "has impossible dimensions");
  const std::uint64_t bytes = page.bytes() * pages;
  judge_length(file, tiff.get(), bytes);
  judge_memory(file, bytes, max_bytes);
  Image image;
  image.name = file.string();
  image.size = {page.width, page.height, pages};
  const TiffSpacing found = spacing_of(file, tiff.get(), pages);
  image.spacing = found.spacing;
  if (tell) image.notes.push_back(found.note);
  judge_geometry(image);
  image.voxels = load_voxels(file, tiff.get(), page, pages);
  return image;
}

}  // namespace certet
