#pragma once
/// \file
/// Where an image lies, whether it lies anywhere, and the products that tell.

#include "certet/image.hpp"

namespace certet {

inline double dot(const Point3& a, const Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Checks size, spacing, origin and axes, which may deviate a little from
/// orthonormal ones.
/// \throws Error `bad_input` with a sentence that names the image.
void check_geometry(const Image& image);

/// Makes the axes of an image that `check_geometry` let pass orthonormal.
void orthonormalise(Image& image);

}  // namespace certet
