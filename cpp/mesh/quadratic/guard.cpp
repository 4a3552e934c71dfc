#include "guard.hpp"

#include <algorithm>

#include "certet/curve.hpp"
#include "jacobian.hpp"
#include "mesh/ranges.hpp"

namespace certet::quadratic {
namespace {

constexpr std::size_t elements_at_once = 1024;

std::int64_t squared(Coord3 bend) {
  return std::int64_t{bend.x} * bend.x + std::int64_t{bend.y} * bend.y +
         std::int64_t{bend.z} * bend.z;
}

/// What is found in some elements.
struct Look {
  std::vector<std::uint64_t> spoiling;  ///< nodes
  double least = 1;
};

void look_at(const SurfaceElement& element, std::span<const Bend> bends, Look& look) {
  std::array<Coord3, 6> own;
  std::int64_t greatest = 0;
  std::uint64_t most_bent = 0;
  for (std::size_t e = 0; e < 6; ++e) {
    own[e] = bend_of(bends, element.nodes[e]);
    const std::int64_t size = squared(own[e]);
    if (size > greatest || (size == greatest && size > 0 && element.nodes[e] < most_bent)) {
      greatest = size;
      most_bent = element.nodes[e];
    }
  }
  if (greatest == 0) return;
  const auto coefficients = jacobian_coefficients(doubled_points(element.corners, own));
  const Wide least = *std::ranges::min_element(coefficients);
  const Wide straight = jacobian_coefficients(doubled_points(element.corners, {}))[0];
  if (least_jacobian_divisor * least < straight) look.spoiling.push_back(most_bent);
  look.least = std::min(look.least, static_cast<double>(least) / static_cast<double>(straight));
}

/// At all elements, from the bends as they are.
Look look_at_all(std::span<const SurfaceElement> elements, std::span<const Bend> bends,
                 Context& context) {
  const auto parts = core::in_ranges(
      elements.size(), elements_at_once, Stage::emit, context,
      [&](std::size_t begin, std::size_t end) {
        Look look;
        for (const SurfaceElement& element : elements.subspan(begin, end - begin))
          look_at(element, bends, look);
        return look;
      });
  Look all;
  for (const Look& part : parts) {
    all.spoiling.insert(all.spoiling.end(), part.spoiling.begin(), part.spoiling.end());
    all.least = std::min(all.least, part.least);
  }
  std::ranges::sort(all.spoiling);
  return all;
}

}  // namespace

double take_back_spoiling(std::span<const SurfaceElement> elements, std::vector<Bend>& bends,
                          Context& context) {
  for (;;) {
    const Look look = look_at_all(elements, bends, context);
    if (look.spoiling.empty()) return look.least;
    std::erase_if(bends, [&](const Bend& bend) {
      return std::ranges::binary_search(look.spoiling, bend.node);
    });
  }
}

}  // namespace certet::quadratic
