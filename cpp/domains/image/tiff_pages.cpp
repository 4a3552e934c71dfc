#include "tiff_pages.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "image_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

int say_nothing(TIFF*, void*, const char*, const char*, va_list) { return 1; }

template <class T>
T tag(TIFF* tiff, std::uint32_t name, T otherwise) {
  T value{};
  return TIFFGetFieldDefaulted(tiff, name, &value) == 1 ? value : otherwise;
}

std::string by(const TiffPage& page) {
  return std::to_string(page.width) + " x " + std::to_string(page.height);
}

void check_page(const fs::path& file, const TiffPage& page) {
  if (page.samples != 1)
    refuse(file, "has " + std::to_string(page.samples) + " numbers per voxel, not 1");
  if (page.width == 0 || page.height == 0) refuse(file, "has no voxels");
  if (page.bits % 8 != 0 && page.bits != 1 && page.bits != 2 && page.bits != 4)
    refuse(file, "has " + std::to_string(page.bits) + " bits per voxel, which is not supported");
  if (page.orientation != ORIENTATION_TOPLEFT)
    refuse(file, "has rows that do not begin at the top left, which is not supported");
}

/// The lines `key=value` that ImageJ writes into the description.
class ImageJ {
 public:
  explicit ImageJ(TIFF* tiff) {
    const char* text = nullptr;
    if (TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &text) == 1 && text != nullptr) text_ = text;
    if (text_.rfind("ImageJ=", 0) != 0) text_.clear();
  }
  [[nodiscard]] bool empty() const { return text_.empty(); }
  [[nodiscard]] std::optional<std::string> value(const std::string& key) const {
    std::istringstream lines(text_);
    for (std::string line; std::getline(lines, line);)
      if (line.rfind(key + "=", 0) == 0) return line.substr(key.size() + 1);
    return {};
  }
  [[nodiscard]] double number(const std::string& key, double otherwise) const {
    const auto text = value(key);
    return text ? std::strtod(text->c_str(), nullptr) : otherwise;
  }

 private:
  std::string text_;
};

/// 0 where the unit is none that we know.
double millimetres(const std::string& unit) {
  if (unit == "mm" || unit == "millimeter") return 1;
  if (unit == "cm") return 10;
  if (unit == "m") return 1000;
  if (unit == "inch") return 25.4;
  if (unit == "nm") return 1e-6;
  if (unit == "um" || unit == "micron" || unit == "micrometer" || unit == "\\u00B5m" ||
      unit == "\u00b5m" || unit == "\xb5m")
    return 1e-3;
  return 0;
}

/// Length of a pixel in units of the resolution; 0 where none is told.
double pixel(TIFF* tiff, std::uint32_t name) {
  float resolution = 0;
  if (TIFFGetField(tiff, name, &resolution) != 1 || !(resolution > 0)) return 0;
  // The 24 bits of a float are seven digits; so 500 is not 500.00001.
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.7g", 1 / static_cast<double>(resolution));
  const double length = std::strtod(digits.data(), nullptr);
  return std::isfinite(length) ? length : 0;
}

void check_imagej(const fs::path& file, const ImageJ& imagej, std::uint32_t pages) {
  for (const char* axis : {"channels", "frames"})
    if (imagej.number(axis, 1) > 1)
      refuse(file, std::string("has 4 dimensions, not 3: ") + axis);
  if (imagej.number("images", pages) != pages)
    refuse(file, "is said to have " + *imagej.value("images") + " pages, but has " +
                     std::to_string(pages));
}

TiffSpacing by_imagej(const ImageJ& imagej, double x, double y) {
  const std::string unit = imagej.value("unit").value_or("");
  const double known = millimetres(unit);
  const double scale = known == 0 ? 1 : known;
  const double z = std::abs(imagej.number("spacing", 0));
  TiffSpacing result;
  result.spacing = {scale * (x == 0 ? 1 : x), scale * (y == 0 ? 1 : y),
                    scale * (z > 0 && std::isfinite(z) ? z : x == 0 ? 1 : x)};
  result.note = known == 0 ? "voxel size by the file's ImageJ tags, in a unit they leave open"
                           : "voxel size in millimetres by the file's ImageJ tags";
  return result;
}

}  // namespace

/// II or MM, and 42, or 43 where offsets have 64 bits.
bool is_tiff(const fs::path& file) {
  std::unique_ptr<FILE, int (*)(FILE*)> stream(std::fopen(file.c_str(), "rb"), &std::fclose);
  unsigned char b[4] = {};
  if (!stream || std::fread(b, 1, 4, stream.get()) != 4) return false;
  const auto version = [](int value) { return value == 42 || value == 43; };
  return (b[0] == 'I' && b[1] == 'I' && version(b[2]) && b[3] == 0) ||
         (b[0] == 'M' && b[1] == 'M' && b[2] == 0 && version(b[3]));
}

Tiff open_tiff(const fs::path& file) {
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options, say_nothing, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options, say_nothing, nullptr);
  Tiff tiff(TIFFOpenExt(file.c_str(), "r", options), &TIFFClose);
  TIFFOpenOptionsFree(options);
  if (!tiff) refuse(file, "is truncated or damaged");
  return tiff;
}

TiffPage page_of(TIFF* tiff) {
  TiffPage page;
  page.width = tag<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH, 0);
  page.height = tag<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 0);
  page.bits = tag<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  page.samples = tag<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  page.format = tag<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  page.orientation = tag<std::uint16_t>(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  page.zero_is_white =
      tag<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK) == PHOTOMETRIC_MINISWHITE;
  return page;
}

std::uint32_t check_pages(const fs::path& file, TIFF* tiff, TiffPage& first) {
  first = page_of(tiff);
  check_page(file, first);
  std::uint32_t pages = 1;
  for (; TIFFLastDirectory(tiff) != 1; ++pages) {
    if (TIFFReadDirectory(tiff) != 1) refuse(file, "is truncated or damaged");
    const TiffPage page = page_of(tiff);
    if (page != first)
      refuse(file, "has pages that differ: number " + std::to_string(pages + 1) + " is " +
                       by(page) + " with " + std::to_string(page.bits) + " bits, the first " +
                       by(first) + " with " + std::to_string(first.bits));
  }
  if (TIFFSetDirectory(tiff, 0) != 1) refuse(file, "is truncated or damaged");
  return pages;
}

TiffSpacing spacing_of(const fs::path& file, TIFF* tiff, std::uint32_t pages) {
  const double x = pixel(tiff, TIFFTAG_XRESOLUTION), y = pixel(tiff, TIFFTAG_YRESOLUTION);
  const ImageJ imagej(tiff);
  check_imagej(file, imagej, pages);
  if (!imagej.empty() && (x > 0 || imagej.value("spacing"))) return by_imagej(imagej, x, y);
  const auto unit = tag<std::uint16_t>(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
  if (x == 0 || y == 0 || unit == RESUNIT_NONE)
    return {{1, 1, 1}, "the file tells no voxel size, which is taken to be 1 (see --spacing)"};
  const double scale = unit == RESUNIT_CENTIMETER ? 10 : 25.4;
  return {{scale * x, scale * y, scale * x},
          "voxel size in millimetres by the file's resolution; pages are taken to be as far "
          "apart as pixels (see --spacing)"};
}

}  // namespace certet
