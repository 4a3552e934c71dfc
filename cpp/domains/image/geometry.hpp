#pragma once
/// \file
/// Whether an image lies anywhere.

#include "certet/image.hpp"

namespace certet {

/// Judges size, spacing, origin and axes, which may deviate a little from
/// orthonormal ones.
/// \throws Error `bad_input` with a sentence that names the image.
void judge_geometry(const Image& image);

/// Makes the axes of an image that `judge_geometry` let pass orthonormal.
void orthonormalise(Image& image);

}  // namespace certet
