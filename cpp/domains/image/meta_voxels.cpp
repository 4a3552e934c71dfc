#include "meta_voxels.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <type_traits>

#include "image_file.hpp"
#include "numbered_files.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_missing(const fs::path& file, const fs::path& missing) {
  refuse(file, "is a header whose voxels are missing: there is no file '" + missing.string() + "'");
}

/// `LIST`, or `LIST 2` where each file holds as many dimensions; names follow.
std::vector<fs::path> listed_files(const fs::path& file, const MetaHeader& header) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(header.length));
  std::vector<fs::path> files;
  for (std::string line; files.size() < most_files && std::getline(stream, line);)
    if (std::string name = split_line(line, "\n").key; !name.empty())
      files.push_back(file.parent_path() / name);
  return files;
}

std::vector<fs::path> other_files(const fs::path& file, const MetaHeader& header,
                                  const std::string& place) {
  std::error_code failure;
  if (fs::is_regular_file(file.parent_path() / place, failure)) return {file.parent_path() / place};
  if (place.rfind("LIST", 0) == 0) return listed_files(file, header);
  return numbered_files(file, place);
}

/// How many files there must be, where each holds the first `held` dimensions.
std::uint64_t wanted_files(const std::string& place, const std::vector<std::uint64_t>& size) {
  std::size_t held = size.size() - 1;
  if (place.rfind("LIST", 0) == 0)
    if (const int told = std::atoi(place.c_str() + 4); told > 0)
      held = static_cast<std::size_t>(told);
  std::uint64_t files = 1;
  for (std::size_t d = held; d < size.size(); ++d) files *= size[d];
  return files;
}

/// Bytes before the voxels; -1 stands for all that are before the last ones.
void skip_header(const fs::path& file, const MetaHeader& header, StoredPart& part) {
  const std::string text = header.value("HeaderSize");
  if (text.empty()) return;
  const long long skip = std::atoll(text.c_str());
  if (skip == 0) return;
  std::error_code failure;
  const std::uint64_t length = fs::file_size(part.file, failure);
  if (skip < -1 || failure || part.packed || (skip == -1 && length < part.bytes))
    refuse(file, "has voxels behind a header of an impossible size");
  part.offset = skip == -1 ? length - part.bytes : static_cast<std::uint64_t>(skip);
}

/// Packed voxels end where they end; a size that cannot be is a sign of damage.
void check_packed_size(const fs::path& file, const MetaHeader& header, const StoredPart& part) {
  const std::string text = header.value("CompressedDataSize");
  if (!part.packed || text.empty()) return;
  std::uint64_t size = 0;
  const auto [stop, failure] = std::from_chars(text.data(), text.data() + text.size(), size);
  std::error_code missing;
  const std::uint64_t length = fs::file_size(part.file, missing);
  if (failure != std::errc() || stop != text.data() + text.size() || missing ||
      part.offset > length || size > length - part.offset)
    refuse(file, "is truncated or damaged: it has an impossible size of packed data");
}

template <class T>
void read_numbers(const fs::path& file, std::istream& stream, std::uint64_t count, char* to) {
  for (std::uint64_t i = 0; i < count; ++i, to += sizeof(T)) {
    std::string word;
    if (!(stream >> word)) refuse(file, "is truncated or damaged: it has fewer numbers than voxels");
    char* end = nullptr;
    T value{};
    if constexpr (std::is_floating_point_v<T>) {
      value = static_cast<T>(std::strtod(word.c_str(), &end));
    } else {
      const long long wide = std::strtoll(word.c_str(), &end, 10);
      if (wide < static_cast<long long>(std::numeric_limits<T>::lowest()) ||
          wide > static_cast<long long>(std::numeric_limits<T>::max()))
        refuse(file, "has a voxel that its type has no room for, '" + word + "'");
      value = static_cast<T>(wide);
    }
    if (end != word.c_str() + word.size() || word.empty())
      refuse(file, "has a voxel that is no number of its type, '" + word + "'");
    std::memcpy(to, &value, sizeof(T));
  }
}

void read_text(const fs::path& file, const StoredPart& part, NumberType type, std::uint64_t count,
               char* to) {
  std::ifstream stream(part.file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(part.offset));
  switch (type) {
    case NumberType::u8: return read_numbers<std::uint8_t>(file, stream, count, to);
    case NumberType::i8: return read_numbers<std::int8_t>(file, stream, count, to);
    case NumberType::u16: return read_numbers<std::uint16_t>(file, stream, count, to);
    case NumberType::i16: return read_numbers<std::int16_t>(file, stream, count, to);
    case NumberType::u32: return read_numbers<std::uint32_t>(file, stream, count, to);
    case NumberType::i32: return read_numbers<std::int32_t>(file, stream, count, to);
    case NumberType::u64:  // beyond what a label can be, all the same
    case NumberType::i64: return read_numbers<std::int64_t>(file, stream, count, to);
    case NumberType::f32: return read_numbers<float>(file, stream, count, to);
    case NumberType::f64: return read_numbers<double>(file, stream, count, to);
  }
}

}  // namespace

MetaVoxels meta_voxels(const fs::path& file, const MetaHeader& header, std::uint64_t bytes,
                       const std::vector<std::uint64_t>& size) {
  MetaVoxels voxels;
  const bool binary = header.value("BinaryData").empty() || header.is_true("BinaryData");
  voxels.text = !binary;
  const bool high_first = header.is_true("BinaryDataByteOrderMSB") || header.is_true("ElementByteOrderMSB");
  voxels.swapped = high_first != (std::endian::native == std::endian::big);
  const std::string& place = header.fields.back().value;
  const bool packed = header.is_true("CompressedData");
  if (voxels.text && packed) refuse(file, "has voxels that are packed text, which is not supported");
  if (lower(place) == "local") {
    voxels.parts.push_back({file, header.length, 0, bytes, packed});
    skip_header(file, header, voxels.parts[0]);
    check_packed_size(file, header, voxels.parts[0]);
    return voxels;
  }
  const auto files = other_files(file, header, place);
  const bool several = files.size() != 1 || place.rfind("LIST", 0) == 0;
  if (several && (files.size() != wanted_files(place, size) || voxels.text))
    refuse(file, "names " + std::to_string(files.size()) + " files of voxels, not " +
                     std::to_string(wanted_files(place, size)));
  std::error_code failure;
  for (const fs::path& other : files) {
    if (!fs::is_regular_file(other, failure)) refuse_missing(file, other);
    voxels.parts.push_back({other, 0, 0, bytes / files.size(), packed});
    skip_header(file, header, voxels.parts.back());
    if (!several) check_packed_size(file, header, voxels.parts.back());
  }
  return voxels;
}

void read_meta_voxels(const fs::path& file, const MetaVoxels& voxels, NumberType type,
                      std::uint64_t count, char* to) {
  if (voxels.text) return read_text(file, voxels.parts.at(0), type, count, to);
  char* const begin = to;
  for (const StoredPart& part : voxels.parts) {
    read_part(part, to);
    to += part.bytes;
  }
  if (voxels.swapped) swap_bytes(begin, count, bytes_of(type));
}

}  // namespace certet
