// Strings, metadata and transforms of a .vdb file.

#include "vdb_parts.hpp"

#include <openvdb/openvdb.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace certet {
namespace {

/// Maps of one size; the numbers are doubles.
constexpr std::pair<std::string_view, std::uint64_t> maps[] = {
    {"AffineMap", 16},         {"UnitaryMap", 16},        {"ScaleMap", 15},
    {"UniformScaleMap", 15},   {"TranslationMap", 3},     {"ScaleTranslateMap", 18},
    {"UniformScaleTranslateMap", 18}};

void skip_linear_map(const VdbPlace& at, const std::string& name) {
  for (const auto& [known, numbers] : maps)
    if (name == known) return at.cursor.skip(8 * numbers);
  at.fail("a grid has a transform that is not known");
}

/// Fewer bytes are made as many before they are packed.
constexpr std::uint64_t least_packed = 128;

/// What speeds up a later reading: of every leaf a byte and, if they are there, 8.
void skip_leaf_sizes(const VdbPlace& at, std::uint64_t bytes) {
  if (bytes == 0) return;
  const std::uint64_t end = at.cursor.position() + bytes;
  const std::uint64_t leaves = at.number<std::uint32_t>();
  const auto skip = [&](std::uint64_t packed, std::uint64_t unpacked) {
    if (packed == 0) at.cursor.skip(unpacked);
    else skip_blosc(at, packed, std::max(unpacked, least_packed));
  };
  skip(at.number<std::uint32_t>(), leaves);
  const auto packed = at.number<std::uint32_t>();
  if (packed != 0xffffffff) skip(packed, 8 * leaves);
  if (at.cursor.position() > end) at.fail("its metadata have a size that cannot be");
  at.cursor.go_to(end);
}

/// OpenVDB reads as many bytes as a type has, whatever the file says of its size.
void skip_value(const VdbPlace& at, const std::string& type) {
  const std::uint64_t bytes = at.number<std::uint32_t>();
  if (bytes > at.cursor.remaining()) at.fail("its metadata have a size that cannot be");
  if (!openvdb::Metadata::isRegisteredType(type) || type == "string") return at.cursor.skip(bytes);
  if (type == "__delayedload") return skip_leaf_sizes(at, bytes);
  if (bytes != openvdb::Metadata::createMetadata(type)->size())
    at.fail("its metadata have a size that cannot be");
  at.cursor.skip(bytes);
}

}  // namespace

std::string VdbPlace::text() const {
  std::string text(cursor.checked(number<std::uint32_t>(), 1, "letters"), '\0');
  cursor.bytes(std::as_writable_bytes(std::span(text)));
  return text;
}

bool VdbPlace::flag() const {
  const auto byte = number<std::uint8_t>();
  if (byte > 1) fail("what should be 0 or 1 is neither");
  return byte != 0;
}

void skip_blosc(const VdbPlace& at, std::uint64_t packed, std::uint64_t unpacked) {
  // Four bytes of how, then the sizes: unpacked, of a block, and packed.  More than
  // this much smaller nothing becomes.
  constexpr std::uint64_t head = 16, greatest_ratio = 1100;
  if (packed < head || packed > at.cursor.remaining() || unpacked / greatest_ratio > packed)
    at.fail("packed numbers have a size that cannot be");
  at.cursor.skip(4);
  const std::uint64_t from = at.number<std::uint32_t>();
  at.cursor.skip(4);
  const std::uint64_t to = at.number<std::uint32_t>();
  if (from != unpacked || to != packed) at.fail("packed numbers have a size that cannot be");
  at.cursor.skip(packed - head);
}

bool skip_metadata(const VdbPlace& at) {
  bool half = false;
  const auto count = at.cursor.checked(at.number<std::uint32_t>(), 3 * 4, "metadata");
  for (std::uint64_t n = 0; n < count; ++n) {
    const std::string name = at.text(), type = at.text();
    if (name == openvdb::GridBase::META_SAVE_HALF_FLOAT && type == "bool") {
      if (at.number<std::uint32_t>() != 1) at.fail("its metadata have a size that cannot be");
      half = at.flag();
    } else {
      skip_value(at, type);
    }
  }
  return half;
}

void skip_transform(const VdbPlace& at) {
  const std::string name = at.text();
  if (name != "NonlinearFrustumMap") return skip_linear_map(at, name);
  at.cursor.skip(8 * (6 + 2));  // its box, its taper and its depth
  skip_linear_map(at, at.text());
}

}  // namespace certet
