#pragma once
/// \file
/// Surface files that are read without assimp, which dies of damaged ones.

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "certet/surface.hpp"
#include "files/formats/cursor.hpp"

namespace certet {

/// Polygons of more corners are refused; to cut them takes cubic time.
inline constexpr std::uint64_t most_corners = 1000;

/// PLY of any of its three forms: elements `vertex` with x, y and z, and `face`
/// with a list `vertex_indices` or `vertex_index`.  All others are passed over.
/// \throws Error `bad_input`.
void read_ply(const formats::InputFile& file, TriangleSurface& surface);

/// OFF as text, also with normals, colours or texture coordinates behind the
/// coordinates of a point, a point or a face on each line.
/// \throws Error `bad_input`.
void read_off(const formats::InputFile& file, TriangleSurface& surface);

/// A whole number without a sign; one that 64 bits do not hold is the greatest.
inline std::uint64_t count_in(std::string_view word, const formats::InputFile& file) {
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (error == std::errc::invalid_argument || end != word.data() + word.size())
    file.fail(formats::in_quotes(word) + " is not a number of things");
  return error == std::errc() ? count : std::numeric_limits<std::uint64_t>::max();
}

/// Rounded to 24 bits, as coordinates of surfaces are.
inline double coordinate(double value, const formats::InputFile& file) {
  if (!(std::fabs(value) <= std::numeric_limits<float>::max()))
    file.fail("it has a coordinate that is not finite, or too large");
  return static_cast<float>(value);
}

/// The number of a point that is there.
inline std::uint32_t corner(double index, const TriangleSurface& surface,
                            const formats::InputFile& file) {
  if (!(index >= 0 && index < static_cast<double>(surface.points.size())) ||
      index != std::floor(index))
    file.fail("it has a face with a point that is not there");
  return static_cast<std::uint32_t>(index);
}

}  // namespace certet
