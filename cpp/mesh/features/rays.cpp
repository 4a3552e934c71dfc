#include "rays.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace certet::features {
namespace {

Coord3 at(const Ray& ray, double steps_out) {
  return in_steps(ray.origin + steps_out * ray.direction);
}

/// Whole steps along a ray between which the solid ends.
struct Bracket {
  std::size_t ray;
  double inside, outside;
};

/// Those of some rays within a reach; the others are left in `rest`.
void bracket(const Domain& domain, std::span<const Ray> rays, double reach,
             std::vector<std::size_t>& rest, std::vector<Bracket>& found) {
  const auto own_reach = [&](std::size_t i) { return std::ceil(std::min(reach, rays[i].reach)); };
  std::vector<Coord3> asked;
  for (const std::size_t i : rest)
    for (const double end : {-own_reach(i), own_reach(i)}) asked.push_back(at(rays[i], end));
  std::vector<Sign> signs(asked.size());
  domain.at(asked, signs);
  std::vector<std::size_t> left;
  for (std::size_t k = 0; k < rest.size(); ++k) {
    const std::size_t i = rest[k];
    if (signs[2 * k] != Sign::minus && signs[2 * k + 1] == Sign::minus)
      found.push_back({i, -own_reach(i), own_reach(i)});
    else if (reach < rays[i].reach)
      left.push_back(i);
  }
  rest = std::move(left);
}

void bisect(const Domain& domain, std::span<const Ray> rays, std::vector<Bracket> open,
            std::span<Hit> hits) {
  const auto middle = [](const Bracket& one) { return std::floor((one.inside + one.outside) / 2); };
  std::vector<Coord3> asked;
  std::vector<Sign> signs;
  while (true) {
    std::erase_if(open, [&](const Bracket& one) {
      if (one.outside - one.inside > 1) return false;
      hits[one.ray] = {true, in_doubles(at(rays[one.ray], one.inside))};
      return true;
    });
    if (open.empty()) return;
    asked.clear();
    for (const Bracket& one : open) asked.push_back(at(rays[one.ray], middle(one)));
    signs.resize(asked.size());
    domain.at(asked, signs);
    for (std::size_t i = 0; i < open.size(); ++i) {
      Bracket& one = open[i];
      const double here = middle(one);
      if (signs[i] != Sign::minus) one.inside = here;
      if (signs[i] != Sign::plus) one.outside = here;
    }
  }
}

}  // namespace

void cast(const Domain& domain, std::span<const Ray> rays, std::span<Hit> hits) {
  constexpr double first_reach = 64, growth = 2;
  std::ranges::fill(hits, Hit{});
  std::vector<std::size_t> rest(rays.size());
  std::iota(rest.begin(), rest.end(), std::size_t{0});
  std::vector<Bracket> found;
  for (double reach = first_reach; !rest.empty(); reach *= growth)
    bracket(domain, rays, reach, rest, found);
  bisect(domain, rays, std::move(found), hits);
}

Hit cast(const Domain& domain, const Ray& ray) {
  Hit hit;
  cast(domain, {&ray, 1}, {&hit, 1});
  return hit;
}

}  // namespace certet::features
