#include "vtu_bytes.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "files/compression/blocks.hpp"

namespace certet::formats {
namespace {

/// What all sources say of themselves when something is wrong.
struct Sentences {
  const InputFile& file;
  std::string array;

  [[noreturn]] void cut_off() const { file.fail("its array " + array + " is cut off"); }
  [[noreturn]] void damaged() const { file.fail("its array " + array + " is damaged"); }
  [[noreturn]] void wrong_size() const {
    file.fail("the size of its array " + array +
              " does not agree with the numbers of points and cells");
  }
};

class RawBytes final : public ByteSource {
 public:
  RawBytes(Sentences say, std::uint64_t begin, std::uint64_t end)
      : say_(std::move(say)), at_(begin), end_(end) {}
  void read(std::span<std::byte> out) override {
    if (at_ > end_ || out.size() > end_ - at_) say_.cut_off();
    say_.file.read_at(at_, out);
    at_ += out.size();
  }

 private:
  Sentences say_;
  std::uint64_t at_, end_;
};

/// Characters in groups of four; padding may stand in the middle, where one
/// encoded piece ends and the next one begins.
class Base64Bytes final : public ByteSource {
 public:
  Base64Bytes(Sentences say, std::uint64_t begin, std::uint64_t end)
      : say_(std::move(say)), at_(begin), end_(end) {}
  void read(std::span<std::byte> out) override {
    for (std::byte& byte : out) {
      if (next_ == count_) decode_group();
      byte = group_[next_++];
    }
  }

 private:
  void decode_group();
  char character();

  static constexpr std::size_t piece = 1 << 16;

  Sentences say_;
  std::uint64_t at_, end_;  ///< in the file
  std::vector<char> text_;
  std::size_t text_at_ = 0;
  std::array<std::byte, 3> group_{};
  std::size_t next_ = 0, count_ = 0;
};

/// The next character that is not a blank.
char Base64Bytes::character() {
  for (;;) {
    if (text_at_ == text_.size()) {
      text_.resize(std::min<std::uint64_t>(piece, end_ - std::min(at_, end_)));
      if (text_.empty()) say_.cut_off();
      say_.file.read_at(at_, std::as_writable_bytes(std::span(text_)));
      at_ += text_.size();
      text_at_ = 0;
    }
    const char c = text_[text_at_++];
    if (c != ' ' && c != '\n' && c != '\r' && c != '\t') return c;
  }
}

/// What a character stands for; -1 for padding, -2 for what is no base64.
int value_of(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  if (c == '/') return 63;
  return c == '=' ? -1 : -2;
}

void Base64Bytes::decode_group() {
  std::uint32_t bits = 0;
  std::size_t padding = 0;
  for (int i = 0; i < 4; ++i) {
    const char c = character();
    if (c == '<') say_.cut_off();
    const int value = value_of(c);
    if (value == -2 || (value >= 0 && padding > 0)) say_.damaged();
    if (value == -1) ++padding;
    bits = bits << 6 | static_cast<std::uint32_t>(std::max(value, 0));
  }
  if (padding > 2) say_.damaged();
  for (std::size_t i = 0; i < 3; ++i)
    group_[i] = static_cast<std::byte>(bits >> (16 - 8 * i) & 0xff);
  next_ = 0;
  count_ = 3 - padding;
}

/// A number of 32 or 64 bits.
std::uint64_t read_size(ByteSource& source, bool wide) {
  std::uint64_t size = 0;
  source.read(std::as_writable_bytes(std::span(&size, 1)).first(wide ? 8 : 4));
  return size;
}

/// Blocks that were packed one by one.
class PackedBytes final : public ByteSource {
 public:
  PackedBytes(Sentences say, std::unique_ptr<ByteSource> source, bool wide, std::uint64_t bytes);
  void read(std::span<std::byte> out) override;

 private:
  void unpack_next();

  Sentences say_;
  std::unique_ptr<ByteSource> source_;
  std::uint64_t block_bytes_ = 0, left_ = 0;  ///< left: bytes not unpacked yet
  std::vector<std::uint64_t> packed_sizes_;
  std::size_t next_block_ = 0;
  std::vector<std::byte> packed_, block_;
  std::size_t at_ = 0;
};

PackedBytes::PackedBytes(Sentences say, std::unique_ptr<ByteSource> source, bool wide,
                         std::uint64_t bytes)
    : say_(std::move(say)), source_(std::move(source)), left_(bytes) {
  const std::uint64_t blocks = read_size(*source_, wide);
  block_bytes_ = read_size(*source_, wide);
  const std::uint64_t last = read_size(*source_, wide);
  const std::uint64_t full = last == 0 ? blocks : blocks - 1;
  // Every block has a size in the file, and together they give the array.
  if (blocks > say_.file.size() || (blocks == 0) != (bytes == 0)) say_.wrong_size();
  if (blocks == 0) return;
  if (block_bytes_ == 0 || full > bytes / block_bytes_ || last > bytes ||
      full * block_bytes_ != bytes - last)
    say_.wrong_size();
  for (std::uint64_t i = 0; i < blocks; ++i) {
    packed_sizes_.push_back(read_size(*source_, wide));
    if (packed_sizes_.back() > say_.file.size()) say_.cut_off();
  }
}

void PackedBytes::unpack_next() {
  if (next_block_ == packed_sizes_.size()) say_.cut_off();
  packed_.resize(packed_sizes_[next_block_++]);
  source_->read(packed_);
  block_.resize(std::min(block_bytes_, left_));
  left_ -= block_.size();
  at_ = 0;
  if (!compression::unpack(packed_, block_)) say_.damaged();
}

void PackedBytes::read(std::span<std::byte> out) {
  while (!out.empty()) {
    if (at_ == block_.size()) unpack_next();
    const std::size_t count = std::min(out.size(), block_.size() - at_);
    std::memcpy(out.data(), block_.data() + at_, count);
    at_ += count;
    out = out.subspan(count);
  }
}

}  // namespace

std::unique_ptr<ByteSource> open_vtu_array(const InputFile& file, const VtuHeader& header,
                                           const std::string& name, const VtuArrayEntry& entry,
                                           std::uint64_t bytes, std::uint64_t end) {
  const Sentences say{file, name};
  const std::uint64_t head = header.wide_sizes ? 8 : 4;
  if (entry.place > end || end - entry.place < head) say.wrong_size();
  std::unique_ptr<ByteSource> source;
  if (entry.encoding == VtuEncoding::raw)
    source = std::make_unique<RawBytes>(say, entry.place, end);
  else
    source = std::make_unique<Base64Bytes>(say, entry.place, end);
  if (header.compressed)
    return std::make_unique<PackedBytes>(say, std::move(source), header.wide_sizes, bytes);
  const std::uint64_t size = read_size(*source, header.wide_sizes);
  if (size > end - entry.place - head) say.cut_off();
  if (size != bytes) say.wrong_size();
  return source;
}

}  // namespace certet::formats
