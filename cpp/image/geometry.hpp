#pragma once
/// \file
/// Whether an image lies anywhere.

#include "certet/image.hpp"

namespace certet {

/// Judges spacing, origin and axes; makes nearly orthonormal axes orthonormal.
/// \throws Error `bad_input` with a sentence that names the image.
void judge_geometry(Image& image);

}  // namespace certet
