#pragma once
/// \file
/// The bytes of an array in a .vtu file, however they are written.

#include <cstddef>
#include <memory>
#include <span>

#include "vtu_header.hpp"

namespace certet::formats {

/// Gives the bytes of an array from first to last.  Fails, by the file, where
/// there are not as many.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  virtual void read(std::span<std::byte> out) = 0;
};

/// The bytes of an array that must have so many; not for ASCII.  Its size in the
/// file is checked before this returns.  `end` is where the data end in the file.
/// \throws Error `bad_input`.
std::unique_ptr<ByteSource> open_vtu_array(const InputFile& file, const VtuHeader& header,
                                           const std::string& name, const VtuArrayEntry& entry,
                                           std::uint64_t bytes, std::uint64_t end);

}  // namespace certet::formats
