#include "completeness.hpp"

#include <zlib.h>

#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>

namespace certet {
namespace {

namespace fs = std::filesystem;

using GzipFile = std::unique_ptr<gzFile_s, decltype(&gzclose)>;

/// Reads files that are not compressed as well.
GzipFile open(const fs::path& file) { return {gzopen(file.c_str(), "rb"), &gzclose}; }

template <class T>
T number(const unsigned char* bytes, bool swapped) {
  std::array<unsigned char, sizeof(T)> copy;
  for (std::size_t i = 0; i < sizeof(T); ++i)
    copy[i] = bytes[swapped ? sizeof(T) - 1 - i : i];
  return std::bit_cast<T>(copy);
}

/// Where the voxels of a single-file NIfTI begin, by its header.
std::uint64_t nifti_offset(const fs::path& file) {
  std::array<unsigned char, 540> header{};
  const GzipFile stream = open(file);
  if (!stream) return 0;
  gzread(stream.get(), header.data(), static_cast<unsigned>(header.size()));
  for (const bool swapped : {false, true}) {
    const auto size = number<std::int32_t>(header.data(), swapped);
    if (size == 348) {
      const auto offset = number<float>(header.data() + 108, swapped);
      return offset > 0 && offset < 1e9F ? static_cast<std::uint64_t>(offset) : 0;
    }
    if (size == 540) return number<std::uint64_t>(header.data() + 168, swapped);
  }
  return 0;
}

/// The length that the end of a gzip file claims, modulo 2^32.
std::uint32_t claimed_length(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::array<unsigned char, 4> tail{};
  stream.seekg(-4, std::ios::end);
  stream.read(reinterpret_cast<char*>(tail.data()), 4);
  return std::uint32_t{tail[0]} | std::uint32_t{tail[1]} << 8 | std::uint32_t{tail[2]} << 16 |
         std::uint32_t{tail[3]} << 24;
}

/// Unpacks up to `length` bytes and tells whether there are as many.
bool unpacks_to(const fs::path& file, std::uint64_t length) {
  const GzipFile stream = open(file);
  std::array<char, 1 << 16> piece;
  std::uint64_t found = 0;
  while (stream && found < length) {
    const int count = gzread(stream.get(), piece.data(), static_cast<unsigned>(piece.size()));
    if (count <= 0) return false;
    found += static_cast<std::uint64_t>(count);
  }
  return true;
}

bool nifti_is_complete(const fs::path& file, std::uint64_t voxel_bytes) {
  const std::uint64_t needed = nifti_offset(file) + voxel_bytes;
  if (file.extension() != ".gz") return fs::file_size(file) >= needed;
  // Only files of one member with nothing behind the voxels agree at once.
  return claimed_length(file) == static_cast<std::uint32_t>(needed) ||
         unpacks_to(file, needed);
}

/// The value behind "key =" in a line of a MetaImage header, or nothing.
bool value_of(const std::string& line, const std::string& key, std::string& value) {
  const std::size_t equals = line.find('=');
  if (line.rfind(key, 0) != 0 || equals == std::string::npos) return false;
  const std::size_t first = line.find_first_not_of(" \t", equals + 1);
  const std::size_t last = line.find_last_not_of(" \t\r");
  value = first == std::string::npos || last < first ? "" : line.substr(first, last - first + 1);
  return true;
}

bool meta_is_complete(const fs::path& file, std::uint64_t voxel_bytes) {
  std::ifstream stream(file, std::ios::binary);
  std::string line, value;
  bool plain = true;
  while (std::getline(stream, line)) {
    if (value_of(line, "CompressedData ", value) || value_of(line, "CompressedData=", value))
      plain = plain && (value.empty() || (value[0] != 'T' && value[0] != 't'));
    if (value_of(line, "BinaryData ", value))
      plain = plain && (value.empty() || (value[0] != 'F' && value[0] != 'f'));
    if (!value_of(line, "ElementDataFile", value)) continue;
    if (!plain) return true;  // unpacking notices
    if (value == "LOCAL" || value == "Local" || value == "local")
      return fs::file_size(file) >= static_cast<std::uint64_t>(stream.tellg()) + voxel_bytes;
    std::error_code failure;
    const auto length = fs::file_size(file.parent_path() / value, failure);
    return failure || length >= voxel_bytes;  // else a list or a pattern of files
  }
  return true;
}

}  // namespace

bool is_complete(const fs::path& file, std::uint64_t voxel_bytes) {
  const std::string extension = file.extension().string();
  if (extension == ".mha" || extension == ".mhd") return meta_is_complete(file, voxel_bytes);
  const bool nifti = extension == ".nii" ||
                     (extension == ".gz" && file.stem().extension() == ".nii");
  return !nifti || nifti_is_complete(file, voxel_bytes);
}

}  // namespace certet
