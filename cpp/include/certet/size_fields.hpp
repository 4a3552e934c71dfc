#pragma once
/// \file
/// How large tetrahedra may be, by a formula or by an image.

#include <string>

#include "certet/image.hpp"
#include "certet/size_field.hpp"

namespace certet {

/// By a formula in x, y, z (world coordinates), as `FormulaDomain` reads it.  \throws Error
/// `bad_input` for one that cannot be read.
SizeField formula_sizes(const std::string& formula);

/// By an image of sizes, in world units, interpolated trilinearly between voxel centres and held
/// constant over the outer half of the outermost voxels.  Asked of points beyond, it throws
/// Error `bad_input`, with one sentence that names the point.
/// \throws Error `bad_input` (an impossible geometry).
SizeField image_sizes(Image image);

}  // namespace certet
