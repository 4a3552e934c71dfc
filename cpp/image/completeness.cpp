#include "completeness.hpp"

#include <zlib.h>

#include <cstddef>
#include <fstream>
#include <vector>

#include "stored_voxels.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

/// Unpacks gzip or zlib data and throws the result away.
class Unpacker {
 public:
  Unpacker() { ready_ = inflateInit2(&stream_, automatic_header) == Z_OK; }
  ~Unpacker() {
    if (ready_) inflateEnd(&stream_);
  }
  Unpacker(const Unpacker&) = delete;
  Unpacker& operator=(const Unpacker&) = delete;

  /// False where the data is damaged.
  bool take(std::vector<unsigned char>& packed, std::size_t count) {
    stream_.next_in = packed.data();
    stream_.avail_in = static_cast<unsigned>(count);
    while (ready_ && stream_.avail_in > 0) {
      if (at_end_ && inflateReset(&stream_) != Z_OK) return false;  // another member
      at_end_ = false;
      if (!step()) return whole_members_ > 0 && at_end_;
    }
    return ready_;
  }

  [[nodiscard]] std::uint64_t unpacked() const { return unpacked_; }
  [[nodiscard]] bool at_end() const { return at_end_; }

 private:
  static constexpr int automatic_header = 32 + 15;

  bool step() {
    stream_.next_out = sink_.data();
    stream_.avail_out = static_cast<unsigned>(sink_.size());
    const int result = inflate(&stream_, Z_NO_FLUSH);
    unpacked_ += sink_.size() - stream_.avail_out;
    if (result == Z_STREAM_END) {
      at_end_ = true;
      ++whole_members_;
      return true;
    }
    if (result == Z_OK || result == Z_BUF_ERROR) return true;
    at_end_ = whole_members_ > 0;  // padding behind a whole member does no harm
    return false;
  }

  z_stream stream_{};
  bool ready_ = false, at_end_ = false;
  int whole_members_ = 0;
  std::uint64_t unpacked_ = 0;
  std::vector<unsigned char> sink_ = std::vector<unsigned char>(1 << 17);
};

bool unpacks_to(const StoredVoxels& voxels, std::uint64_t length) {
  std::ifstream stream(voxels.file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(voxels.offset));
  std::vector<unsigned char> packed(1 << 16);
  Unpacker unpacker;
  while (stream) {
    stream.read(reinterpret_cast<char*>(packed.data()),
                static_cast<std::streamsize>(packed.size()));
    if (!unpacker.take(packed, static_cast<std::size_t>(stream.gcount()))) break;
  }
  return unpacker.at_end() && unpacker.unpacked() >= length;
}

}  // namespace

bool is_complete(const fs::path& file, std::uint64_t voxel_bytes) {
  const auto voxels = stored_voxels(file);
  if (!voxels) return true;
  if (voxels->packed) return unpacks_to(*voxels, voxels->lead + voxel_bytes);
  std::error_code failure;
  const auto length = fs::file_size(voxels->file, failure);
  return failure || length >= voxels->offset + voxels->lead + voxel_bytes;
}

}  // namespace certet
