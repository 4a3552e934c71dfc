#pragma once
/// \file
/// A file that is read at given places.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "certet/context.hpp"

namespace certet::formats {

/// All members throw Error `bad_input` with a sentence that names the file, and
/// `cancelled`.
class InputFile {
 public:
  /// Where a context is given, reading ends when it is cancelled.
  explicit InputFile(const std::filesystem::path& file, const Context* context = nullptr);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// Fills `bytes` from a place in the file, which must hold as many.
  void read_at(std::uint64_t offset, std::span<std::byte> bytes) const;

  [[noreturn]] void fail(const std::string& reason) const;

 private:
  [[noreturn]] void fail_with(int error) const;

  std::filesystem::path file_;
  const Context* context_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace certet::formats
