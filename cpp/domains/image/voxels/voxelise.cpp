#include "certet/voxelise.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "certet/error.hpp"
#include "engine/parallel.hpp"
#include "held_centres.hpp"

namespace certet {
namespace {

/// Layers of voxels that one task fills.
constexpr std::int64_t layers_at_once = 8;
/// Tetrahedra between two looks at whether to stop.
constexpr std::size_t tets_at_once = 1 << 16;

[[noreturn]] void refuse_point(const std::string& reason) {
  throw Error(ErrorCode::bad_input, "the mesh cannot be voxelised: " + reason);
}

const Point3& point(const FileMesh& mesh, std::uint64_t number) {
  if (number >= mesh.points.size()) refuse_point("a tetrahedron names a point that is not there");
  return mesh.points[number];
}

VoxelRange box_of(const Image& grid) {
  return {{0, 0, 0}, {grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1}};
}

/// All tetrahedra, by the layers of voxels whose centres they may hold.
class TetsByLayers {
 public:
  TetsByLayers(const FileMesh& mesh, const Image& grid, const Context& context)
      : mesh_(mesh), frame_(grid), whole_(box_of(grid)),
        starts_(static_cast<std::size_t>((grid.size[2] + layers_at_once - 1) / layers_at_once) + 1) {
    for_each(context, [&](std::size_t slab, std::size_t) { ++starts_[slab + 1]; });
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    tets_ = Buffer<std::uint64_t>(starts_.back());
    std::vector<std::uint64_t> next(starts_.begin(), std::prev(starts_.end()));
    for_each(context, [&](std::size_t slab, std::size_t tet) { tets_[next[slab]++] = tet; });
  }

  [[nodiscard]] std::size_t slabs() const { return starts_.size() - 1; }
  [[nodiscard]] std::uint64_t flat() const { return flat_; }

  /// The voxels of a slab.
  [[nodiscard]] VoxelRange box(std::size_t slab) const {
    VoxelRange box = whole_;
    box.first[2] = static_cast<std::int64_t>(slab) * layers_at_once;
    box.last[2] = std::min(box.last[2], box.first[2] + layers_at_once - 1);
    return box;
  }

  /// Numbers of tetrahedra, ascending.
  [[nodiscard]] std::span<const std::uint64_t> tets(std::size_t slab) const {
    return std::span(tets_.data(), tets_.size()).subspan(starts_[slab], starts_[slab + 1] - starts_[slab]);
  }

  [[nodiscard]] FineCorners corners(std::size_t number) const {
    FineCorners corners{};
    for (std::size_t c = 0; c < 4; ++c) {
      const std::optional<FinePoint> fine = frame_.fine(point(mesh_, mesh_.tets[number][c]));
      if (!fine)
        refuse_point("a point is not finite, or 262,144 voxels away from the first voxel");
      corners[c] = *fine;
    }
    return corners;
  }

 private:
  /// Calls visit(slab, tet) for all that may hold a centre, tetrahedra ascending.
  template <class Visit>
  void for_each(const Context& context, const Visit& visit) {
    flat_ = 0;
    for (std::size_t number = 0; number < mesh_.tets.size(); ++number) {
      if (number % tets_at_once == 0) stop_if_cancelled(context);
      const FineCorners at = corners(number);
      if (volume(at) == 0) {
        ++flat_;
        continue;
      }
      const VoxelRange box = voxels_around(at, whole_);
      if (box.empty()) continue;
      for (std::int64_t slab = box.first[2] / layers_at_once; slab <= box.last[2] / layers_at_once;
           ++slab)
        visit(static_cast<std::size_t>(slab), number);
    }
  }

  const FileMesh& mesh_;
  VoxelFrame frame_;
  VoxelRange whole_;
  std::vector<std::uint64_t> starts_;
  Buffer<std::uint64_t> tets_;
  std::uint64_t flat_ = 0;
};

/// What a slab counted.
struct Counts {
  std::uint64_t held = 0, twice = 0;
};

/// The layers of a grid, filled slab by slab.
class Layers {
 public:
  explicit Layers(const Image& grid)
      : width_(grid.size[0]), layer_(grid.size[0] * grid.size[1]),
        labels_(static_cast<std::size_t>(layer_ * grid.size[2])) {}

  Counts fill(const FileMesh& mesh, const TetsByLayers& tets, std::size_t slab,
              const Context& context) {
    const VoxelRange box = tets.box(slab);
    const std::int64_t begin = box.first[2] * layer_, end = (box.last[2] + 1) * layer_;
    std::fill(labels_.begin() + begin, labels_.begin() + end, 0);
    std::vector<std::uint8_t> times(static_cast<std::size_t>(end - begin));
    std::size_t done = 0;
    for (const std::uint64_t number : tets.tets(slab)) {
      if (++done % tets_at_once == 0) stop_if_cancelled(context);
      const std::int32_t label = mesh.labels.empty() ? 1 : mesh.labels[number];
      const FineCorners corners = tets.corners(number);
      TetAmongVoxels(corners).held(voxels_around(corners, box), [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        const std::int64_t at = i + j * width_ + k * layer_;
        std::uint8_t& count = times[static_cast<std::size_t>(at - begin)];
        if (count == 0) labels_[static_cast<std::size_t>(at)] = label;
        count = static_cast<std::uint8_t>(std::min(count + 1, 2));
      });
    }
    return {times.size() - static_cast<std::uint64_t>(std::ranges::count(times, 0)),
            static_cast<std::uint64_t>(std::ranges::count(times, 2))};
  }

  Buffer<std::int32_t> take() && { return std::move(labels_); }

 private:
  std::int64_t width_, layer_;
  Buffer<std::int32_t> labels_;
};

void check_grid(const Image& grid) {
  check_geometry(grid);
  for (const std::int64_t along : grid.size)
    if (along > farthest_voxel)
      throw Error(ErrorCode::too_large, "'" + grid.name + "' has " + std::to_string(along) +
                                            " voxels along an axis, more than the " +
                                            std::to_string(farthest_voxel) + " that there may be");
}

}  // namespace

Image grid_around(const FileMesh& mesh, const Point3& spacing) {
  constexpr double none = std::numeric_limits<double>::infinity();
  Point3 low{none, none, none}, high{-none, -none, -none};
  for (const Tet<std::uint64_t>& tet : mesh.tets)
    for (const std::uint64_t corner : tet)
      for (std::size_t a = 0; a < 3; ++a) {
        const double at = point(mesh, corner)[a];
        if (!std::isfinite(at)) refuse_point("a point is not finite");
        low[a] = std::min(low[a], at);
        high[a] = std::max(high[a], at);
      }
  if (mesh.tets.empty()) refuse_point("it has no tetrahedra");
  Image grid;
  grid.name = "the grid";
  grid.spacing = spacing;
  for (std::size_t a = 0; a < 3; ++a) {
    if (!(spacing[a] > 0) || !std::isfinite(spacing[a]))
      throw Error(ErrorCode::bad_option, "a spacing is a positive number");
    const double voxels = std::max(1.0, std::ceil((high[a] - low[a]) / spacing[a]));
    if (!(voxels <= static_cast<double>(farthest_voxel)))
      throw Error(ErrorCode::too_large, "the spacing is too small: the mesh is more than " +
                                            std::to_string(farthest_voxel) + " voxels long");
    grid.size[a] = static_cast<std::int64_t>(voxels);
    grid.origin[a] = low[a] + spacing[a] / 2;
  }
  return grid;
}

VoxelisedMesh voxelise(const FileMesh& mesh, Image grid, Context& context) {
  check_grid(grid);
  const TetsByLayers tets(mesh, grid, context);
  Layers layers(grid);
  std::vector<Counts> counts(tets.slabs());
  core::parallel_for(context, Stage::emit, static_cast<std::int64_t>(tets.slabs()),
                     [&](std::int64_t slab) {
                       const auto at = static_cast<std::size_t>(slab);
                       counts[at] = layers.fill(mesh, tets, at, context);
                     });
  VoxelisedMesh result;
  result.image = std::move(grid);
  result.image.voxels = std::move(layers).take();
  result.image.names = mesh.names;
  result.flat_tets = tets.flat();
  result.has_region_0 = std::ranges::find(mesh.labels, 0) != mesh.labels.end();
  for (const Counts& slab : counts) {
    result.held += slab.held;
    result.held_twice += slab.twice;
  }
  return result;
}

VoxelisedMesh voxelise(const Mesh& mesh, Image grid, Context& context) {
  FileMesh world;
  const Buffer<Point3> points = world_points(mesh);
  world.points.assign(points.begin(), points.end());
  std::visit(
      [&](const auto& tets) {
        world.tets.reserve(tets.size());
        for (const auto& [a, b, c, d] : tets) world.tets.push_back({a, b, c, d});
      },
      mesh.tets);
  world.labels.assign(mesh.labels.begin(), mesh.labels.end());
  world.names = mesh.names;
  return voxelise(world, std::move(grid), context);
}

std::vector<std::string> warnings_on_voxels(const VoxelisedMesh& made) {
  std::vector<std::string> warnings;
  if (made.held_twice > 0)
    warnings.push_back(std::to_string(made.held_twice) + " voxels have their centres in several "
                       "tetrahedra: the mesh overlaps itself");
  if (made.held == 0) warnings.emplace_back("no voxel has its centre in the mesh");
  if (made.has_region_0)
    warnings.emplace_back("the mesh has a region 0, whose voxels look like those outside");
  return warnings;
}

}  // namespace certet
