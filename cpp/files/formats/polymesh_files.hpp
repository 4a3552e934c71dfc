#pragma once
/// \file
/// The files of OpenFOAM's folder polyMesh.

#include <array>
#include <cstdint>
#include <string_view>

namespace certet::formats {

inline constexpr std::array<std::string_view, 7> polymesh_files{
    "points", "faces", "owner", "neighbour", "boundary", "cellZones", "faceZones"};

/// What the writer holds of each tetrahedron, and for putting faces in order.
inline constexpr std::uint64_t polymesh_bytes_of_tet = 120;

}  // namespace certet::formats
