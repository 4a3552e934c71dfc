#pragma once
/// \file
/// A stretch of an output file that is written from its beginning to its end.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "output_file.hpp"

namespace certet::formats {

/// Several of them can grow side by side in one file.  Small pieces are
/// gathered, large ones go straight to the file.
class Section {
 public:
  Section(OutputFile& file, std::uint64_t offset) : file_(file), offset_(offset) {}

  void append(std::span<const std::byte> bytes);
  /// `append` for numbers, byte for byte.
  template <class T>
  void append_all(std::span<const T> values) {
    append(std::as_bytes(values));
  }

  /// What was gathered goes to the file.
  void flush();

 private:
  static constexpr std::size_t capacity = std::size_t{1} << 20;

  OutputFile& file_;
  std::uint64_t offset_;  ///< of the first byte that is not in the file
  std::vector<std::byte> gathered_;
};

}  // namespace certet::formats
