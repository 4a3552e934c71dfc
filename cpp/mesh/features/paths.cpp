#include "paths.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace certet::features {
namespace {

/// A triangle beside a jump.
struct Port {
  std::uint32_t triangle = none;
  bool first_on_left = false;  ///< to one who comes into the triangle
};

class PathFinder {
 public:
  PathFinder(const SeenSurface& surface, std::span<const Jump> jumps)
      : surface_(surface), jumps_(jumps), ports_(jumps.size()), used_(jumps.size()),
        of_triangles_(surface.triangles.size(), {none, none, none}) {
    for (std::uint32_t t = 0; t < of_triangles_.size(); ++t) see(t);
  }

  Paths all() {
    for (std::uint32_t j = 0; j < jumps_.size(); ++j)
      for (std::size_t side = 0; side < 2; ++side)
        if (used_[j] == 0 && ends_at(ports_[j][side])) walk(j, side);
    for (std::uint32_t j = 0; j < jumps_.size(); ++j)
      if (used_[j] == 0) walk(j, 0);
    return std::move(paths_);
  }

 private:
  [[nodiscard]] std::uint32_t jump_of(std::uint32_t v, std::uint32_t w) const {
    const std::array<std::uint32_t, 2> ends{std::min(v, w), std::max(v, w)};
    const auto found = std::ranges::lower_bound(jumps_, ends, {}, &Jump::ends);
    return found != jumps_.end() && found->ends == ends
               ? static_cast<std::uint32_t>(found - jumps_.begin())
               : none;
  }

  void see(std::uint32_t t) {
    const auto& corners = surface_.triangles[t];
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t j = jump_of(corners[i], corners[(i + 1) % 3]);
      of_triangles_[t][i] = j;
      if (j == none) continue;
      ++count;
      // Where more than two triangles meet, at other than two ports the way ends.
      auto& [one, other] = ports_[j];
      (one.triangle == none ? one : other) = {t, corners[i] == jumps_[j].ends[0]};
    }
    if (count == 3) {
      junction_of_[t] = static_cast<std::uint32_t>(paths_.junctions.size());
      paths_.junctions.push_back({of_triangles_[t], corners});
    }
  }

  [[nodiscard]] std::size_t count_in(std::uint32_t t) const {
    return 3 - static_cast<std::size_t>(std::ranges::count(of_triangles_[t], none));
  }
  [[nodiscard]] bool ends_at(const Port& port) const {
    return port.triangle == none || count_in(port.triangle) != 2;
  }
  [[nodiscard]] std::uint32_t junction_at(const Port& port) const {
    const auto found = junction_of_.find(port.triangle);
    return found == junction_of_.end() ? none : found->second;
  }

  /// Away from one of the sides of a jump.
  void walk(std::uint32_t jump, std::size_t from_side) {
    Path path;
    path.from = junction_at(ports_[jump][from_side]);
    const std::uint32_t begin = jump;
    while (true) {
      used_[jump] = 1;
      const Port& next = ports_[jump][1 - from_side];
      path.jumps.push_back(jump);
      path.first_on_left.push_back(next.triangle != none ? next.first_on_left
                                                         : !ports_[jump][from_side].first_on_left);
      if (ends_at(next)) {
        path.to = junction_at(next);
        break;
      }
      const auto& three = of_triangles_[next.triangle];
      const std::uint32_t other =
          *std::ranges::find_if(three, [&](std::uint32_t j) { return j != none && j != jump; });
      if (used_[other] != 0) {
        path.is_loop = other == begin;
        break;
      }
      from_side = ports_[other][0].triangle == next.triangle ? 0 : 1;
      jump = other;
    }
    paths_.paths.push_back(std::move(path));
  }

  const SeenSurface& surface_;
  std::span<const Jump> jumps_;
  std::vector<std::array<Port, 2>> ports_;
  std::vector<std::uint8_t> used_;
  std::vector<std::array<std::uint32_t, 3>> of_triangles_;
  std::map<std::uint32_t, std::uint32_t> junction_of_;  ///< of triangles
  Paths paths_;
};

}  // namespace

Paths find_paths(const SeenSurface& surface, std::span<const Jump> jumps) {
  return PathFinder(surface, jumps).all();
}

}  // namespace certet::features
