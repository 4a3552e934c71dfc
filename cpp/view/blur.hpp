#pragma once
/// \file
/// Blurring, by running sums.

#include <vector>

namespace certet::view {

/// Three means over boxes of 2 `radius` + 1 pixels, which is nearly a Gaussian;
/// the image goes on beyond its border as it is there.
std::vector<float> blurred(const std::vector<float>& image, int width, int radius);

}  // namespace certet::view
