#pragma once
/// \file
/// Voxels out of ITK's readers.

#include <itkImageIOBase.h>

#include <cstdint>
#include <filesystem>
#include <functional>

#include "certet/image.hpp"

namespace certet {

/// `fill` writes `bytes` bytes of voxels of that type; 64-bit labels are kept
/// where they fit 32 bits.
/// \throws Error `bad_input` naming the file.
Voxels load_voxels(const std::filesystem::path& file, itk::IOComponentEnum type,
                   std::uint64_t bytes, const std::function<void(void*)>& fill);

}  // namespace certet
