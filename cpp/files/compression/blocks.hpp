#pragma once
/// \file
/// Blocks of bytes, packed one by one in zlib's format.

#include <cstddef>
#include <span>
#include <vector>

namespace certet::compression {

/// \throws Error `bad_option` where zlib was left out.
std::vector<std::byte> pack(std::span<const std::byte> block);

/// Fills `block`; false where the packed bytes are damaged, or give more or less.
/// \throws Error `bad_input` where zlib was left out.
bool unpack(std::span<const std::byte> packed, std::span<std::byte> block);

}  // namespace certet::compression
