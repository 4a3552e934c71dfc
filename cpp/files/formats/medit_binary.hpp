#pragma once
/// \file
/// Binary MEDIT files: a mark and a version, then blocks.  Each block is a keyword,
/// the place of the next block, and (but for the last) what the keyword says.
/// Keywords are of 32 bits; places and counts are of 32 bits up to version 2 and
/// of 64 bits from 3 on; vertex numbers and references are of 32 bits up to
/// version 3; coordinates are doubles from version 2 on.

#include <cstdint>

namespace certet::formats::medit_binary {

/// The first 32 bits, in the order of the machine that wrote the file.
inline constexpr std::int32_t mark = 1;

enum Keyword : std::int32_t {
  dimension = 3,
  vertices = 4,
  triangles = 6,
  tetrahedra = 8,
  triangles_p2 = 24,   ///< of six nodes
  tetrahedra_p2 = 30,  ///< of ten nodes
  end = 54,
  tetrahedra_p2_ordering = 133,  ///< where a file has its nodes in another order
};

}  // namespace certet::formats::medit_binary
