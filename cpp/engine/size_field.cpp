#include "certet/size_field.hpp"

#include <cstddef>
#include <sstream>
#include <utility>
#include <vector>

#include "certet/error.hpp"
#include "certet/lattice/coord3.hpp"

namespace certet {
namespace {

[[noreturn]] void refuse(const SizeField& sizes, const Point3& at, double size) {
  std::ostringstream sentence;
  sentence.precision(9);
  sentence << "the size field, " << sizes.name << ", is " << size << " at (" << at[0] << ", "
           << at[1] << ", " << at[2] << "), where sizes are to be positive";
  throw Error(ErrorCode::bad_input, sentence.str());
}

}  // namespace

std::int32_t levels_within(double greatest, double size) {
  std::int32_t levels = 0;
  while (levels < most_grading_levels && size * (2 << levels) <= greatest) ++levels;
  return levels;
}

void keep_within(SizeField sizes, const Frame& frame, Grading& grading) {
  grading.at_points = [sizes = std::move(sizes), frame](std::span<const Coord3> points,
                                                        std::span<std::int32_t> levels) {
    std::vector<Point3> places(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) places[i] = frame.world(steps * points[i]);
    std::vector<double> wanted(points.size());
    sizes.at(places, wanted);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!(wanted[i] > 0)) refuse(sizes, places[i], wanted[i]);
      levels[i] = levels_within(wanted[i], frame.size);
    }
  };
}

}  // namespace certet
