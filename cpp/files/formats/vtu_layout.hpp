#pragma once
/// \file
/// Where everything stands in a .vtu file, known from the mesh's size alone.

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "certet/formats.hpp"

namespace certet::formats {

/// The name that VTK has for this machine's order of bytes.
inline constexpr std::string_view vtu_byte_order =
    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

/// VTK's numbers for tetrahedra of four and of ten nodes.
inline constexpr std::uint8_t vtk_tetra = 10, vtk_quadratic_tetra = 24;

/// An array of the appended data: its size in bytes as UInt64, then the bytes.
struct VtuArray {
  std::string_view type;      ///< VTK's name of the number type
  std::uint64_t bytes = 0;    ///< of the numbers
  std::uint64_t offset = 0;   ///< of the size, from the beginning of the data

  [[nodiscard]] bool is_64_bit() const { return type == "Int64"; }
};

/// The layout: `header`, the arrays in the order given here, `footer`.
struct VtuLayout {
  explicit VtuLayout(const MeshSize& size);

  std::uint64_t per_tet;  ///< nodes
  std::uint8_t cell_type;  ///< VTK's
  VtuArray points, connectivity, offsets, types;
  VtuArray label;      ///< no bytes and no place if there are no labels
  std::string header;  ///< the XML up to the underscore that opens the data
  std::string footer;
  std::uint64_t file_bytes = 0;

  /// Where the size of an array stands in the file.
  [[nodiscard]] std::uint64_t place(const VtuArray& array) const {
    return header.size() + array.offset;
  }
};

/// The XML before the data, with the arrays where the layout has them.
std::string vtu_header_of(const VtuLayout& layout, const MeshSize& size, bool compressed);

}  // namespace certet::formats
