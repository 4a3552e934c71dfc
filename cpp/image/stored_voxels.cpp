#include "stored_voxels.hpp"

#include <zlib.h>

#include <array>
#include <bit>
#include <fstream>
#include <memory>
#include <string>

#include "header_lines.hpp"
#include "meta_header.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

template <class T>
T number(const unsigned char* bytes, bool swapped) {
  std::array<unsigned char, sizeof(T)> copy;
  for (std::size_t i = 0; i < sizeof(T); ++i)
    copy[i] = bytes[swapped ? sizeof(T) - 1 - i : i];
  return std::bit_cast<T>(copy);
}

/// The field `vox_offset` of NIfTI-1 or NIfTI-2, in either byte order.
std::uint64_t nifti_offset(const std::array<unsigned char, 540>& header) {
  for (const bool swapped : {false, true}) {
    const auto size = number<std::int32_t>(header.data(), swapped);
    if (size == 540) return number<std::uint64_t>(header.data() + 168, swapped);
    if (size != 348) continue;
    const auto offset = number<float>(header.data() + 108, swapped);
    return offset > 0 && offset < 1e9F ? static_cast<std::uint64_t>(offset) : 0;
  }
  return 0;
}

std::optional<StoredVoxels> in_nifti(const fs::path& file, bool packed) {
  // Reads files that are not packed as well.
  const std::unique_ptr<gzFile_s, decltype(&gzclose)> stream(gzopen(file.c_str(), "rb"),
                                                             &gzclose);
  std::array<unsigned char, 540> header{};
  if (!stream) return {};
  gzread(stream.get(), header.data(), static_cast<unsigned>(header.size()));
  return StoredVoxels{file, 0, nifti_offset(header), packed};
}

/// The voxels begin behind the first empty line.
std::optional<StoredVoxels> in_nrrd(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string line, encoding;
  while (std::getline(stream, line)) {
    const auto [key, value] = split_line(line, ":");
    if (key.empty() && value.empty()) break;
    if (key == "encoding") encoding = lower(value);
    if (key == "data file" || key == "datafile" || key == "line skip" || key == "byte skip")
      return {};
  }
  const bool packed = encoding == "gzip" || encoding == "gz";
  if (!stream || (!packed && encoding != "raw")) return {};
  return StoredVoxels{file, static_cast<std::uint64_t>(stream.tellg()), 0, packed};
}

/// The voxels begin behind the line ElementDataFile, or in the file it names.
std::optional<StoredVoxels> in_meta(const fs::path& file) {
  const auto header = meta_header(file);
  if (!header) return {};
  bool packed = false;
  for (const auto& [key, value] : header->fields) {
    if (key == "CompressedData") packed = lower(value) == "true";
    if (key == "BinaryData" && lower(value) == "false") return {};
    if (key == "HeaderSize") return {};
  }
  const std::string& place = header->fields.back().value;
  if (lower(place) == "local") return StoredVoxels{file, header->length, 0, packed};
  std::error_code failure;
  const fs::path other = file.parent_path() / place;
  if (!fs::is_regular_file(other, failure)) return {};  // a list or a pattern of files
  return StoredVoxels{other, 0, 0, packed};
}

}  // namespace

std::optional<StoredVoxels> stored_voxels(const fs::path& file) {
  const std::string extension = lower(file.extension().string());
  if (extension == ".nii") return in_nifti(file, false);
  if (extension == ".gz" && lower(file.stem().extension().string()) == ".nii")
    return in_nifti(file, true);
  if (extension == ".nrrd") return in_nrrd(file);
  return in_meta(file);
}

}  // namespace certet
