#include "patches.hpp"

#include <span>
#include <utility>

#include "edges.hpp"
#include "vectors.hpp"

namespace certet {
namespace {

/// Across an edge of two triangles.
struct Neighbour {
  std::uint32_t triangle = none;
  bool agrees = true;  ///< runs along the edge the other way, as neighbours should
};

std::vector<std::array<Neighbour, 3>> neighbours(const TriangleSurface& surface) {
  std::vector<std::array<Neighbour, 3>> all(surface.triangles.size());
  for_each_edge(sides_of(surface), [&](std::span<const TriangleSide> edge) {
    if (edge.size() != 2) return;
    const bool agrees = edge[0].backward != edge[1].backward;
    all[edge[0].triangle][edge[0].corner] = {edge[1].triangle, agrees};
    all[edge[1].triangle][edge[1].corner] = {edge[0].triangle, agrees};
  });
  return all;
}

class Agreement {
 public:
  explicit Agreement(TriangleSurface& surface)
      : surface_(surface), neighbours_(neighbours(surface)), turned_(surface.triangles.size()) {
    patches_.of.assign(surface.triangles.size(), none);
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
      if (patches_.of[t] == none) spread_from(t);
  }

  SurfacePatches find(std::uint64_t& turned) && {
    if (!patches_.orientable) return std::move(patches_);
    choose_less();
    for (std::size_t t = 0; t < turned_.size(); ++t) {
      if (!turned_[t]) continue;
      std::swap(surface_.triangles[t][1], surface_.triangles[t][2]);
      ++turned;
    }
    return std::move(patches_);
  }

 private:
  /// Over the patch of a triangle, which stays as it is.
  void spread_from(std::uint32_t start) {
    std::vector<std::uint32_t> front{start};
    patches_.of[start] = patches_.count;
    while (!front.empty()) {
      const std::uint32_t t = front.back();
      front.pop_back();
      for (const auto& [other, agrees] : neighbours_[t]) {
        if (other == none) continue;
        const bool turn = turned_[t] == agrees;
        if (patches_.of[other] == none) {
          patches_.of[other] = patches_.count;
          turned_[other] = turn;
          front.push_back(other);
        } else if (turned_[other] != turn) {
          patches_.orientable = false;
        }
      }
    }
    ++patches_.count;
  }

  /// Turns the others of a patch where they are less.
  void choose_less() {
    struct Sums {
      double turned = 0, kept = 0, volume = 0;
      bool any = false;
    };
    std::vector<Sums> sums(patches_.count);
    const Point3& origin = surface_.points[surface_.triangles[0][0]];
    for (std::size_t n = 0; n < turned_.size(); ++n) {
      const auto& t = surface_.triangles[n];
      const Point3& corner = surface_.points[t[0]];
      const Point3 area = area_vector(corner, surface_.points[t[1]], surface_.points[t[2]]);
      Sums& of = sums[patches_.of[n]];
      (turned_[n] ? of.turned : of.kept) += length(area);
      of.any = of.any || turned_[n];
      of.volume += (turned_[n] ? -1 : 1) * dot(difference(corner, origin), area);
    }
    for (std::size_t n = 0; n < turned_.size(); ++n) {
      const Sums& of = sums[patches_.of[n]];
      const double more = of.turned - of.kept, about_equal = 1e-9 * (of.turned + of.kept);
      if (of.any && (more > about_equal || (more > -about_equal && of.volume < 0)))
        turned_[n] = !turned_[n];
    }
  }

  TriangleSurface& surface_;
  std::vector<std::array<Neighbour, 3>> neighbours_;
  std::vector<bool> turned_;
  SurfacePatches patches_;
};

}  // namespace

SurfacePatches agreed_patches(TriangleSurface& surface, std::uint64_t& turned) {
  return Agreement(surface).find(turned);
}

}  // namespace certet
