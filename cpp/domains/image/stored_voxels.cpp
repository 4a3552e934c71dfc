#include "stored_voxels.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <vector>

#include "image_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

/// Unpacks gzip or zlib data; keeps the bytes of one stretch of it.
class Unpacker {
 public:
  /// Keeps nothing where `to` is null.
  Unpacker(char* to, const StoredPart& part) : to_(to), lead_(part.lead), left_(part.bytes) {
    ready_ = inflateInit2(&stream_, automatic_header) == Z_OK;
  }
  ~Unpacker() {
    if (ready_) inflateEnd(&stream_);
  }
  Unpacker(const Unpacker&) = delete;
  Unpacker& operator=(const Unpacker&) = delete;

  /// False where the data is damaged or ends.
  bool take(std::vector<unsigned char>& packed, std::size_t count) {
    stream_.next_in = packed.data();
    stream_.avail_in = static_cast<unsigned>(count);
    while (ready_ && stream_.avail_in > 0) {
      if (at_end_ && inflateReset(&stream_) != Z_OK) return false;  // another member
      at_end_ = false;
      if (!step()) return false;
    }
    return ready_;
  }

  /// Whether all was there, and the data ended where it says.
  [[nodiscard]] bool whole() const { return at_end_ && lead_ == 0 && left_ == 0; }

 private:
  static constexpr int automatic_header = 32 + 15;

  bool step() {
    const bool kept = lead_ == 0 && left_ > 0 && to_ != nullptr;
    const std::uint64_t wanted = lead_ > 0 ? lead_ : left_ > 0 ? left_ : sink_.size();
    const std::uint64_t room = std::min<std::uint64_t>(wanted, kept ? 1U << 30 : sink_.size());
    stream_.next_out = kept ? reinterpret_cast<unsigned char*>(to_) : sink_.data();
    stream_.avail_out = static_cast<unsigned>(room);
    const int result = inflate(&stream_, Z_NO_FLUSH);
    const std::uint64_t got = room - stream_.avail_out;
    if (kept) to_ += got;
    std::uint64_t& counted = lead_ > 0 ? lead_ : left_;
    counted -= std::min(counted, got);
    if (result == Z_STREAM_END) return at_end_ = had_whole_member_ = true;
    if (result == Z_OK || result == Z_BUF_ERROR) return true;
    at_end_ = had_whole_member_;  // padding behind a whole member does no harm
    return false;
  }

  z_stream stream_{};
  char* to_;
  std::uint64_t lead_, left_;
  bool ready_ = false, at_end_ = false, had_whole_member_ = false;
  std::vector<unsigned char> sink_ = std::vector<unsigned char>(1 << 17);
};

bool unpack(const StoredPart& part, char* to) {
  std::ifstream stream(part.file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(part.offset));
  std::vector<unsigned char> packed(1 << 16);
  Unpacker unpacker(to, part);
  while (stream) {
    stream.read(reinterpret_cast<char*>(packed.data()),
                static_cast<std::streamsize>(packed.size()));
    if (!unpacker.take(packed, static_cast<std::size_t>(stream.gcount()))) break;
  }
  return unpacker.whole();
}

std::uint64_t bytes_behind(const StoredPart& part) {
  std::error_code failure;
  const std::uint64_t length = fs::file_size(part.file, failure);
  return failure || length < part.offset ? 0 : length - part.offset;
}

/// Read in steps, for a stream's count has a sign.
bool copy(const StoredPart& part, char* to) {
  std::ifstream stream(part.file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(part.offset + part.lead));
  for (std::uint64_t left = part.bytes; left > 0 && stream;) {
    const auto step = static_cast<std::streamsize>(std::min<std::uint64_t>(left, 1U << 30));
    stream.read(to, step);
    if (stream.gcount() != step) return false;
    to += step;
    left -= static_cast<std::uint64_t>(step);
  }
  return static_cast<bool>(stream);
}

}  // namespace

bool is_packed(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  char b[2] = {};
  stream.read(b, 2);
  return stream && b[0] == '\x1f' && b[1] == '\x8b';
}

void check_length(const StoredPart& part) {
  const std::uint64_t greatest_ratio = part.packed ? 1040 : 1;
  const std::uint64_t there = bytes_behind(part);
  if ((part.lead + part.bytes) / greatest_ratio <= there) return;
  if (there > 0 || part.packed)
    refuse(part.file, "is truncated or damaged: it is too short for the dimensions in its header");
  refuse(part.file, "is truncated or damaged: it has no voxels");
}

void read_part(const StoredPart& part, char* to) {
  check_length(part);
  if (!(part.packed ? unpack(part, to) : copy(part, to)))
    refuse(part.file, "is truncated or damaged");
}

void check_part(const StoredPart& part) {
  check_length(part);
  if (part.packed && !unpack(part, nullptr)) refuse(part.file, "is truncated or damaged");
}

}  // namespace certet
