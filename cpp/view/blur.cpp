#include "blur.hpp"

#include <algorithm>
#include <cstddef>

namespace certet::view {
namespace {

/// The mean over a box along one line of the image, in place.
void blur_line(float* first, std::ptrdiff_t stride, int count, int radius,
               std::vector<float>& line) {
  line.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) line[static_cast<std::size_t>(i)] = first[i * stride];
  const auto at = [&](int i) {
    return static_cast<double>(line[static_cast<std::size_t>(std::clamp(i, 0, count - 1))]);
  };
  double sum = 0;
  for (int i = -radius; i <= radius; ++i) sum += at(i);
  for (int i = 0; i < count; ++i) {
    first[i * stride] = static_cast<float>(sum / (2 * radius + 1));
    sum += at(i + radius + 1) - at(i - radius);
  }
}

}  // namespace

std::vector<float> blurred(const std::vector<float>& image, int width, int radius) {
  std::vector<float> result = image;
  std::vector<float> line;
  const int height = static_cast<int>(image.size()) / width;
  for (int round = 0; round < 3; ++round) {
    for (int y = 0; y < height; ++y)
      blur_line(result.data() + std::ptrdiff_t{y} * width, 1, width, radius, line);
    for (int x = 0; x < width; ++x) blur_line(result.data() + x, width, height, radius, line);
  }
  return result;
}

}  // namespace certet::view
