#include "blocks.hpp"

#include <zlib.h>

#include <new>

#include "certet/error.hpp"
#include "certet/formats.hpp"

namespace certet {

bool can_compress() { return true; }

namespace compression {
namespace {

/// Beyond this, time grows faster than size shrinks.
constexpr int level = 3;

}  // namespace

std::vector<std::byte> pack(std::span<const std::byte> block) {
  uLongf bytes = compressBound(block.size());
  std::vector<std::byte> packed(bytes);
  const int result =
      compress2(reinterpret_cast<Bytef*>(packed.data()), &bytes,
                reinterpret_cast<const Bytef*>(block.data()), block.size(), level);
  if (result != Z_OK) throw std::bad_alloc();
  packed.resize(bytes);
  return packed;
}

bool unpack(std::span<const std::byte> packed, std::span<std::byte> block) {
  uLongf bytes = block.size();
  const int result =
      uncompress(reinterpret_cast<Bytef*>(block.data()), &bytes,
                 reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  return result == Z_OK && bytes == block.size();
}

}  // namespace compression
}  // namespace certet
