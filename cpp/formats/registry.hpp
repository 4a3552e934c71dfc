#pragma once
/// \file
/// What each format has to offer to the table in formats.cpp.

#include <cstdint>
#include <filesystem>
#include <memory>

#include "certet/formats.hpp"

namespace certet::formats {

std::unique_ptr<MeshWriter> open_vtu(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t vtu_bytes(const MeshSize& size);
FileMesh read_vtu(const std::filesystem::path& file);

std::unique_ptr<MeshWriter> open_medit(const std::filesystem::path& file, const MeshSize& size);
std::uint64_t medit_bytes(const MeshSize& size);
FileMesh read_medit(const std::filesystem::path& file);

}  // namespace certet::formats
