#pragma once
/// \file
/// The files of OpenFOAM's folder polyMesh.

#include <array>
#include <string_view>

namespace certet::formats {

inline constexpr std::array<std::string_view, 7> polymesh_files{
    "points", "faces", "owner", "neighbour", "boundary", "cellZones", "faceZones"};

}  // namespace certet::formats
