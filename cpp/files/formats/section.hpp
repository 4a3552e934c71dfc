#pragma once
/// \file
/// A stretch of an output file that is written from its beginning to its end.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "line.hpp"
#include "output_file.hpp"

namespace certet::formats {

/// Several of them can grow side by side in one file.  Small pieces are
/// gathered, large ones go straight to the file.
class Section {
 public:
  Section(WritableFile& file, std::uint64_t offset, std::size_t capacity = std::size_t{1} << 20)
      : file_(&file), offset_(offset), capacity_(capacity) {}

  void append(std::span<const std::byte> bytes);
  /// `append` for numbers, byte for byte.
  template <class T>
  void append_all(std::span<const T> values) {
    append(std::as_bytes(values));
  }

  void append(const Line& line) { append_all(line.text()); }
  void append_text(std::string_view text) { append_all(std::span<const char>(text)); }

  /// Where the next byte comes in the file.
  [[nodiscard]] std::uint64_t end() const { return offset_ + gathered_.size(); }

  /// What was gathered goes to the file.
  void flush();

 private:
  WritableFile* file_;
  std::uint64_t offset_;  ///< of the first byte that is not in the file
  std::size_t capacity_;   ///< bytes that are gathered at most
  std::vector<std::byte> gathered_;
};

}  // namespace certet::formats
