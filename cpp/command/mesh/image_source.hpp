#pragma once
/// \file
/// Images from files, as the options want them.

#include <cstdint>
#include <filesystem>

#include "mesh_options.hpp"
#include "source.hpp"

namespace certet::command {

/// Labels, merged where that is asked for, or `gray` values; of neither any is NaN where that is
/// so.  \throws Error.
Image open_image(const std::filesystem::path& file, const MeshOptions& options, bool gray,
                 std::uint64_t max_bytes);

/// By default surfaces are smooth where the method cuts labels apart.
LabelSurfaces surfaces_of(const MeshOptions& options);

}  // namespace certet::command
