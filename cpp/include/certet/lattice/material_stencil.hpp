#pragma once
/// \file
/// The stencils where several materials meet: how the materials of its corners turn a
/// structured tetrahedron into tetrahedra of each material.

#include <array>
#include <cstddef>
#include <cstdint>

#include "certet/lattice/stencil.hpp"

namespace certet {

/// The owner of a tetrahedron whose corners have all moved: its material is none of theirs.
inline constexpr std::uint8_t shared_owner = 4;

/// A tetrahedron of a material: that of corner `owner`.  A cut is named by its ends, the
/// lower number first, for either may be of the higher material.
struct MaterialTet {
  UnstructuredTet vertices{};
  std::uint8_t owner = 0;
};

/// One to eight tetrahedra, which fill the structured one.
struct MaterialStencil {
  std::uint8_t count = 0;
  std::array<MaterialTet, 8> tets{};

  [[nodiscard]] constexpr const MaterialTet* begin() const { return tets.data(); }
  [[nodiscard]] constexpr const MaterialTet* end() const { return tets.data() + count; }
};

/// What a corner is: its material, 0 being the outside, or `moved_corner`, which lies on
/// the surface of one.
inline constexpr std::int32_t moved_corner = -1;
using CornerMaterials = std::array<std::int32_t, 4>;

/// Tells in which ways four corners are alike: four bits for those that have moved, six
/// for the pairs of one material.
inline constexpr std::size_t likeness_count = 1024;

constexpr std::size_t likeness(const CornerMaterials& corners) {
  std::size_t code = 0;
  std::size_t bit = 0;
  for (std::size_t a = 0; a < 4; ++a) code |= std::size_t{corners[a] == moved_corner} << bit++;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = a + 1; b < 4; ++b)
      code |= std::size_t{corners[a] == corners[b]} << bit++;
  return code;
}

/// All patterns of materials, each once: a corner has moved or is of one of four materials,
/// and which of them is which makes no difference.
inline constexpr std::size_t material_pattern_count = 52;
inline constexpr std::array<CornerMaterials, material_pattern_count> material_patterns = [] {
  std::array<CornerMaterials, material_pattern_count> patterns{};
  std::array<bool, likeness_count> seen{};
  std::size_t count = 0;
  for (int n = 0; n < 5 * 5 * 5 * 5; ++n) {
    const CornerMaterials corners{n % 5 - 1, n / 5 % 5 - 1, n / 25 % 5 - 1, n / 125 - 1};
    bool& is_known = seen[likeness(corners)];
    if (!is_known) patterns[count++] = corners;
    is_known = true;
  }
  return patterns;
}();

/// The pattern of a likeness; those that no corners have are of none.
inline constexpr std::array<std::uint8_t, likeness_count> pattern_of_likeness = [] {
  std::array<std::uint8_t, likeness_count> pattern_of{};
  pattern_of.fill(material_pattern_count);
  for (std::uint8_t n = 0; n < material_pattern_count; ++n)
    pattern_of[likeness(material_patterns[n])] = n;
  return pattern_of;
}();

namespace stencil_detail {

/// What remains between the tetrahedra of each material, where three or four meet: a
/// letter for each corner, 0 for one that has moved, and tetrahedra in the notation of
/// `Representative`, each after the corner whose material it is of.
struct Fill {
  const char* corners;
  const char* tets;
};

/// `MaterialFill` of the certificate.
inline constexpr std::array<Fill, 11> fills{{
    {"ABCD", "1 12 34 13 14 | 2 12 34 24 23 | 3 12 34 23 13 | 4 12 34 14 24"},
    {"AABC", "1 13 14 23 34 | 1 14 24 23 34"},
    {"ABCC", "3 13 14 12 23 | 3 14 24 12 23"},
    {"ABAC", "2 12 34 24 23 | 4 12 34 14 24"},
    {"ABCB", "1 12 34 13 14 | 3 12 34 23 13"},
    {"ABCA", "2 12 34 24 23 | 3 12 34 23 13"},
    {"ABBC", "1 12 34 13 14 | 4 12 34 14 24"},
    {"0ABC", "2 1 34 24 23"},
    {"A0BC", "1 2 34 13 14"},
    {"AB0C", "4 3 12 24 14"},
    {"ABC0", "3 4 12 13 23"},
}};

constexpr CornerMaterials materials_of(const char* corners) {
  CornerMaterials materials{};
  for (std::size_t c = 0; c < 4; ++c)
    materials[c] = corners[c] == '0' ? moved_corner : corners[c] - 'A';
  return materials;
}

/// One material against the rest.
constexpr CornerSigns signs_of(const CornerMaterials& corners, std::int32_t material) {
  CornerSigns signs{};
  for (std::size_t c = 0; c < 4; ++c)
    signs[c] = corners[c] == moved_corner ? Sign::on_surface
               : corners[c] == material   ? Sign::plus
                                          : Sign::minus;
  return signs;
}

constexpr void add_tets_of_one(MaterialStencil& stencil, const CornerMaterials& corners,
                               std::uint8_t owner) {
  for (UnstructuredTet tet : unstructured_tets(signs_of(corners, corners[owner]))) {
    for (StencilVertex& vertex : tet)
      if (vertex.a > vertex.b) vertex = {vertex.b, vertex.a};
    stencil.tets[stencil.count++] = {tet, owner};
  }
}

constexpr void add_fill(MaterialStencil& stencil, const char* tets) {
  for (const char* c = tets; *c != '\0'; ++c) {
    if (*c == ' ' || *c == '|') continue;
    MaterialTet& tet = stencil.tets[stencil.count++];
    tet.owner = static_cast<std::uint8_t>(corner_of(*c++));
    for (StencilVertex& vertex : tet.vertices) {
      ++c;
      vertex.a = vertex.b = static_cast<std::uint8_t>(corner_of(*c++));
      if (*c >= '1' && *c <= '4') vertex.b = static_cast<std::uint8_t>(corner_of(*c++));
    }
    if (*c == '\0') break;
  }
}

constexpr MaterialStencil make_material_stencil(const CornerMaterials& corners) {
  MaterialStencil stencil;
  bool moved = true;
  for (std::uint8_t c = 0; c < 4; ++c) {
    if (corners[c] == moved_corner) continue;
    moved = false;
    bool seen = false;
    for (std::uint8_t before = 0; before < c; ++before)
      seen = seen || corners[before] == corners[c];
    if (!seen) add_tets_of_one(stencil, corners, c);
  }
  if (moved) return {1, {{{{{{0, 0}, {1, 1}, {2, 2}, {3, 3}}}, shared_owner}}}};
  for (const Fill& fill : fills)
    if (likeness(materials_of(fill.corners)) == likeness(corners)) add_fill(stencil, fill.tets);
  return stencil;
}

}  // namespace stencil_detail

/// By pattern.
inline constexpr std::array<MaterialStencil, material_pattern_count> material_stencil_table = [] {
  std::array<MaterialStencil, material_pattern_count> table{};
  for (std::size_t n = 0; n < table.size(); ++n)
    table[n] = stencil_detail::make_material_stencil(material_patterns[n]);
  return table;
}();

/// `GetMaterialTets` of the certificate.
constexpr const MaterialStencil& material_tets(const CornerMaterials& corners) {
  return material_stencil_table[pattern_of_likeness[likeness(corners)]];
}

}  // namespace certet
