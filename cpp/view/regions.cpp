#include "regions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "certet/tet_shape.hpp"

namespace certet::view {
namespace {

double volume_of(const FileMesh& mesh, std::uint64_t number) {
  const auto& tet = mesh.tets[number];
  if (!has_corners(mesh.points, tet)) return 0;
  std::array<Point3, 3> e;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      e[i][axis] = mesh.points[tet[i + 1]][axis] - mesh.points[tet[0]][axis];
  const auto& [a, b, c] = e;
  return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
          a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
}

std::int32_t label_of(const FileMesh& mesh, std::uint64_t tet) {
  return mesh.labels.empty() ? 0 : mesh.labels[tet];
}

/// Which regions have a point in common, by their places.
using Touching = std::vector<std::set<std::size_t>>;

Touching touching_regions(const FileMesh& mesh, const Regions& regions) {
  Touching touching(regions.all().size());
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> at(mesh.points.size(), none);
  for (std::uint64_t i = 0; i < mesh.tets.size(); ++i) {
    const std::size_t place = regions.place(mesh, i);
    for (const std::uint64_t point : mesh.tets[i]) {
      if (point >= at.size()) continue;
      if (at[point] != none && at[point] != place) {
        touching[at[point]].insert(place);
        touching[place].insert(at[point]);
      }
      at[point] = place;
    }
  }
  return touching;
}

/// Each takes the hue that the fewest of those it touches have, and of these the one that is
/// used the least.
std::vector<Rgb> colors_apart(const Touching& touching) {
  std::vector<Rgb> colors;
  std::vector<std::size_t> hue_of;
  std::array<std::size_t, hues> used{};
  for (const std::set<std::size_t>& others : touching) {
    std::array<std::pair<std::size_t, std::size_t>, hues> cost{};
    for (const std::size_t other : others)
      if (other < hue_of.size()) ++cost[hue_of[other]].first;
    for (std::size_t hue = 0; hue < hues; ++hue) cost[hue].second = used[hue];
    const auto hue = static_cast<std::size_t>(std::ranges::min_element(cost) - cost.begin());
    hue_of.push_back(hue);
    colors.push_back(region_color(hue, used[hue]++));
  }
  return colors;
}

}  // namespace

Regions::Regions(const FileMesh& mesh) {
  // Neighbours mostly have the same label.
  std::size_t last = 0;
  for (std::uint64_t i = 0; i < mesh.tets.size(); ++i) {
    const std::int32_t label = label_of(mesh, i);
    if (last >= regions_.size() || regions_[last].label != label) {
      last = find(label);
      if (last == regions_.size() || regions_[last].label != label)
        regions_.insert(regions_.begin() + static_cast<std::ptrdiff_t>(last), {label, 0, 0});
    }
    ++regions_[last].tets;
    regions_[last].volume += volume_of(mesh, i);
  }
  colors_ = colors_apart(regions_.size() > hues ? touching_regions(mesh, *this)
                                                : Touching(regions_.size()));
}

std::size_t Regions::place(const FileMesh& mesh, std::uint64_t tet) const {
  return find(label_of(mesh, tet));
}

std::size_t Regions::find(std::int32_t label) const {
  const auto at = std::ranges::lower_bound(regions_, label, {}, &MeasuredRegion::label);
  return static_cast<std::size_t>(at - regions_.begin());
}

}  // namespace certet::view
