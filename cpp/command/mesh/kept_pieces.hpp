#pragma once
/// \file
/// A size at which a mesh has the pieces of its image.

#include <string>

#include "certet/image.hpp"
#include "certet/pieces.hpp"
#include "kept_volume.hpp"

namespace certet::command {

/// Whether these may be the pieces of a region of the image, where voxels that touch at
/// edges and corners may be joined or not.
bool keeps_pieces(const ImageRegion& region, const PieceCount& mesh);

/// As the end of a sentence: a size below this one at which the whole mesh has the pieces
/// of a region, counted there, or that none was found.
std::string size_for_pieces(const KeepingSize::CountAt& count_at, double below,
                            const ImageRegion& region, Context& context);

}  // namespace certet::command
