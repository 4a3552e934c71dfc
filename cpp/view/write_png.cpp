#include <png.h>

#include <string>
#include <vector>

#include "certet/error.hpp"
#include "certet/picture.hpp"
#include "files/formats/output_file.hpp"

namespace certet {
namespace {

/// Collects what libpng writes.
using Bytes = std::vector<std::byte>;

void append(png_structp png, png_bytep data, png_size_t size) {
  auto& bytes = *static_cast<Bytes*>(png_get_io_ptr(png));
  const auto* first = reinterpret_cast<const std::byte*>(data);
  // Beyond libpng's C frames no exception may pass.
  try {
    bytes.insert(bytes.end(), first, first + size);
  } catch (...) {
    png_error(png, "out of memory");
  }
}

void no_flush(png_structp) {}

/// False if libpng gave up.  Has no local that would need a destructor, which a
/// long jump would skip.
bool encode(png_structp png, png_infop info, const Picture& picture, Bytes* bytes) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, bytes, append, no_flush);
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width),
               static_cast<png_uint_32>(picture.height), 8, PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(png, info);
  const std::size_t row = 3 * static_cast<std::size_t>(picture.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y)
    png_write_row(png, picture.rgb.data() + y * row);
  png_write_end(png, nullptr);
  return true;
}

}  // namespace

bool can_write_png() { return true; }

void write_png(const Picture& picture, const std::filesystem::path& file) {
  formats::OutputFile output(file);
  Bytes bytes;
  // libpng would otherwise print.
  const auto give_up = [](png_structp png, png_const_charp) { png_longjmp(png, 1); };
  const auto ignore = [](png_structp, png_const_charp) {};
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, give_up, ignore);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  const bool done = info != nullptr && encode(png, info, picture, &bytes);
  png_destroy_write_struct(&png, &info);
  if (!done) output.fail("the PNG library failed");
  output.write_at(0, bytes);
  output.commit();
}

}  // namespace certet
