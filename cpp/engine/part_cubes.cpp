#include "part_cubes.hpp"

#include "layer_loop.hpp"

namespace certet::core {
namespace {

/// The even neighbours of the odd points of word w.
CubeCorners cubes_around(const SignPlanes& planes, int j, int k, int w) {
  CubeCorners plus;
  for (int n = 0; n < 8; ++n)
    plus[static_cast<std::size_t>(n)] =
        shifted(planes.plus(even, j + (n >> 1 & 1), k + (n >> 2)), w, n & 1);
  return plus;
}

}  // namespace

std::uint64_t parted_cubes(const CubeCorners& plus) {
  CubeCorners reached;
  std::uint64_t seen = 0;
  for (std::size_t n = 0; n < plus.size(); ++n) {
    reached[n] = plus[n] & ~seen;  // the first of each cube
    seen |= plus[n];
  }
  // Corners of a group are no more than four edges apart.
  for (int edges = 0; edges < 4; ++edges)
    for (std::size_t n = 0; n < plus.size(); ++n)
      reached[n] |= plus[n] & (reached[n ^ 1] | reached[n ^ 2] | reached[n ^ 4]);
  std::uint64_t parted = 0;
  for (std::size_t n = 0; n < plus.size(); ++n) parted |= plus[n] & ~reached[n];
  return parted;
}

void part_cubes(SignPlanes& planes, Window window, Context& context) {
  for_each_layer(context, Stage::sample, window, [&](std::int32_t k) {
    for (int j = 0; j < planes.cells()[1]; ++j)
      for (int w = 0; w < planes.words(); ++w) {
        std::uint64_t& inner = planes.plus(odd, j, k)[w];
        if (inner != 0) inner &= ~parted_cubes(cubes_around(planes, j, k, w));
      }
  });
}

}  // namespace certet::core
