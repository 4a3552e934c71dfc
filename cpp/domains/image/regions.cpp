#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <utility>

#include "certet/error.hpp"
#include "certet/image.hpp"
#include "label_set.hpp"
#include "pieces.hpp"

namespace certet {
namespace {

constexpr std::uint32_t nothing = 0xffffffff;

/// From labels to regions, which come ascending.  Labels come in runs.
class RegionOf {
 public:
  explicit RegionOf(const std::vector<ImageRegion>& regions) : regions_(regions) {}

  std::uint32_t operator()(std::int64_t label) {
    if (label == last_) return found_;
    last_ = label;
    const auto at = std::lower_bound(
        regions_.begin(), regions_.end(), label,
        [](const ImageRegion& region, std::int64_t value) { return region.label < value; });
    const bool known = at != regions_.end() && at->label == label;
    return found_ = known ? static_cast<std::uint32_t>(at - regions_.begin()) : nothing;
  }

 private:
  const std::vector<ImageRegion>& regions_;
  std::int64_t last_ = std::numeric_limits<std::int64_t>::min();
  std::uint32_t found_ = nothing;
};

/// Which region a voxel belongs to.
class VoxelRegion {
 public:
  VoxelRegion(const std::vector<ImageRegion>& regions, std::optional<double> level)
      : region_(regions), level_(level) {}
  template <class T>
  std::uint32_t operator()(T voxel) {
    if (level_) return static_cast<double>(voxel) > *level_ ? 0 : nothing;
    if constexpr (std::is_integral_v<T>) return region_(static_cast<std::int64_t>(voxel));
    return nothing;
  }

 private:
  RegionOf region_;
  std::optional<double> level_;
};

template <class T>
void append_runs(std::span<const T> voxels, VoxelRegion& region_of, Row& row) {
  for (std::size_t x = 0; x < voxels.size();) {
    std::size_t end = x + 1;
    while (end < voxels.size() && voxels[end] == voxels[x]) ++end;
    const std::uint32_t region = region_of(voxels[x]);
    const auto first = static_cast<std::int64_t>(x), last = static_cast<std::int64_t>(end) - 1;
    if (region != nothing) {
      if (!row.empty() && row.back().region == region && row.back().last + 1 == first)
        row.back().last = last;
      else
        row.push_back({first, last, region});
    }
    x = end;
  }
}

template <class T>
std::span<const T> voxel_row(const Image& image, const Buffer<T>& voxels, std::int64_t y,
                             std::int64_t z) {
  return {voxels.data() + static_cast<std::size_t>((z * image.size[1] + y) * image.size[0]),
          static_cast<std::size_t>(image.size[0])};
}

constexpr std::array<Link, 2> by_faces{{{false, -1, 0, 0}, {true, 0, 0, 0}}};
constexpr std::array<Link, 4> by_corners{
    {{false, -1, 1, 1}, {true, -1, 1, 1}, {true, 0, 1, 1}, {true, 1, 1, 1}}};

std::vector<std::uint64_t> image_pieces(const Image& image, std::size_t regions,
                                        std::span<const Link> links, VoxelRegion region_of,
                                        const Context& context) {
  return std::visit(
      [&](const auto& voxels) {
        return certet::count_pieces(
            static_cast<std::int32_t>(image.size[1]), static_cast<std::int32_t>(image.size[2]),
            regions,
            [&](std::int32_t y, std::int32_t z, Row& row) {
              append_runs(voxel_row(image, voxels, y, z), region_of, row);
            },
            [&](std::int32_t) { return links; }, context);
      },
      image.voxels);
}

/// Rows 2j are the even points of a layer, rows 2j+1 the odd ones, which are half a
/// long edge further along all axes.
constexpr std::array<Link, 5> of_even{
    {{false, -2, 0, 0}, {true, 0, 0, 0}, {true, -1, 1, 0}, {true, 1, 1, 0}, {false, -1, 1, 0}}};
constexpr std::array<Link, 3> of_odd{{{false, -2, 0, 0}, {true, 0, 0, 0}, {false, -1, 0, 1}}};

/// Finds the runs of a row of lattice points.  In a mesh with warped vertices,
/// pieces may besides touch in faces whose corners all lie on the surface.
class LatticeRows {
 public:
  LatticeRows(const PlacedDomain& domain, std::vector<ImageRegion>& regions)
      : domain_(domain), regions_(regions), region_of_(regions),
        signs_(static_cast<std::size_t>(domain.lattice().cells[0])), materials_(signs_.size()) {}

  void operator()(std::int32_t r, std::int32_t k, Row& row) {
    const std::int32_t odd = r & 1;
    const Coord3 first =
        domain_.lattice().origin + Coord3{odd, (r & ~1) + odd, 2 * k + odd};
    const std::span<const std::int32_t> labels = domain_.labels();
    if (labels.size() > 1) domain_.row_materials(first, materials_);
    else find_signs(first);
    for (std::size_t i = 0; i < materials_.size(); ++i) {
      if (materials_[i] == 0) continue;
      const std::int64_t label =
          labels.empty() ? 0 : labels[static_cast<std::size_t>(materials_[i]) - 1];
      add(static_cast<std::int64_t>(i), region_of_(label), row);
    }
  }

 private:
  void find_signs(Coord3 first) {
    domain_.row(first, signs_);
    std::ranges::transform(signs_, materials_.begin(),
                           [](Sign sign) { return Material{sign == Sign::plus}; });
  }

  void add(std::int64_t i, std::uint32_t region, Row& row) {
    if (region == nothing) return;
    ++regions_[region].points;
    if (!row.empty() && row.back().region == region && row.back().last + 1 == i)
      row.back().last = i;
    else
      row.push_back({i, i, region});
  }

  const PlacedDomain& domain_;
  std::vector<ImageRegion>& regions_;
  RegionOf region_of_;
  std::vector<Sign> signs_;
  std::vector<Material> materials_;
};

/// The edge, in voxels, of the largest cube in a region: of the cubes that end at a
/// voxel, the largest is one larger than the least of its seven neighbours'.
template <class T>
std::int32_t largest_cube(const Image& image, const Buffer<T>& voxels, std::uint32_t region,
                          VoxelRegion& region_of) {
  const auto width = static_cast<std::size_t>(image.size[0]) + 1;
  const auto height = static_cast<std::size_t>(image.size[1]) + 1;
  std::vector<std::int32_t> before(width * height, 0), layer(before);
  std::int32_t largest = 0;
  for (std::int64_t z = 0; z < image.size[2]; ++z) {
    for (std::int64_t y = 0; y < image.size[1]; ++y) {
      const auto row = voxel_row(image, voxels, y, z);
      std::int32_t* now = layer.data() + (static_cast<std::size_t>(y) + 1) * width + 1;
      const std::int32_t* old = before.data() + (static_cast<std::size_t>(y) + 1) * width + 1;
      for (std::size_t x = 0; x < row.size(); ++x, ++now, ++old) {
        const std::int32_t* up = now - width;
        const std::int32_t* old_up = old - width;
        *now = region_of(row[x]) != region
                   ? 0
                   : 1 + std::min({now[-1], up[0], up[-1], old[0], old[-1], old_up[0], old_up[-1]});
        largest = std::max(largest, *now);
      }
    }
    std::swap(before, layer);
  }
  return largest;
}

double finest(const Image& image) {
  return *std::min_element(image.spacing.begin(), image.spacing.end());
}

template <class T>
void count_labels(const Image& image, const Buffer<T>& voxels, const LabelSet& set,
                  std::vector<ImageRegion>& regions) {
  std::vector<std::pair<std::int64_t, std::uint64_t>> runs;  // label, voxels
  for (std::int64_t z = 0; z < image.size[2]; ++z) {
    for (std::int64_t y = 0; y < image.size[1]; ++y)
      for (auto row = voxel_row(image, voxels, y, z); !row.empty();) {
        const auto end = std::ranges::find_if(row, [&](T voxel) { return voxel != row[0]; });
        const auto count = static_cast<std::uint64_t>(end - row.begin());
        if (runs.empty() || runs.back().first != static_cast<std::int64_t>(row[0]))
          runs.emplace_back(row[0], 0);
        runs.back().second += count;
        row = row.subspan(count);
      }
    // One entry for each label, so that there are never many.
    std::sort(runs.begin(), runs.end());
    std::size_t kept = 0;
    for (std::size_t i = 1; i < runs.size(); ++i) {
      if (runs[i].first == runs[kept].first)
        runs[kept].second += runs[i].second;
      else
        runs[++kept] = runs[i];
    }
    runs.resize(std::min(runs.size(), kept + 1));
  }
  for (const auto& [label, count] : runs)
    if (set.contains(label)) {
      ImageRegion region;
      region.label = static_cast<std::int32_t>(label);
      region.voxels = count;
      regions.push_back(region);
    }
}

}  // namespace

std::vector<ImageRegion> regions_of_labels(const Image& image, std::vector<LabelRange> labels) {
  const LabelSet set(std::move(labels));
  std::vector<ImageRegion> regions;
  std::visit(
      [&]<class T>(const Buffer<T>& voxels) {
        if constexpr (std::is_integral_v<T>) count_labels(image, voxels, set, regions);
      },
      image.voxels);
  return regions;
}

std::vector<ImageRegion> regions_of_level(const Image& image, double level) {
  ImageRegion region;
  std::visit(
      [&](const auto& voxels) {
        region.voxels = static_cast<std::uint64_t>(
            std::count_if(voxels.begin(), voxels.end(),
                          [&](auto v) { return static_cast<double>(v) > level; }));
      },
      image.voxels);
  return {region};
}

double volume_of_labels(const Image& image, const std::vector<LabelRange>& labels) {
  std::uint64_t voxels = 0;
  for (const ImageRegion& region : regions_of_labels(image, labels)) voxels += region.voxels;
  return static_cast<double>(voxels) * image.spacing[0] * image.spacing[1] * image.spacing[2];
}

PieceBounds pieces_above(const Image& image, double level, const Context& context) {
  const std::vector<ImageRegion> regions(1);
  const auto count = [&](std::span<const Link> links) {
    return image_pieces(image, 1, links, {regions, level}, context)[0];
  };
  return {count(by_corners), count(by_faces)};
}

void count_pieces(const Image& image, std::optional<double> level, const PlacedDomain& domain,
                  std::vector<ImageRegion>& regions, const Context& context) {
  const auto faces = image_pieces(image, regions.size(), by_faces, {regions, level},
                                  context);
  const Lattice& lattice = domain.lattice();
  LatticeRows rows(domain, regions);
  const auto found = count_pieces(
      2 * lattice.cells[1], lattice.cells[2], regions.size(),
      [&rows](std::int32_t r, std::int32_t k, Row& row) { rows(r, k, row); },
      [](std::int32_t r) {
        return r % 2 == 0 ? std::span<const Link>(of_even) : std::span<const Link>(of_odd);
      },
      context);
  const auto corners =
      faces == found ? faces
                     : image_pieces(image, regions.size(), by_corners, {regions, level}, context);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    ImageRegion& region = regions[r];
    region.pieces_by_faces = faces[r];
    region.pieces_by_corners = corners[r];
    region.lattice_pieces = found[r];
  }
}

void find_certain_size(const Image& image, std::optional<double> level,
                       std::vector<ImageRegion>& regions, std::size_t which) {
  VoxelRegion region_of(regions, level);
  std::visit(
      [&](const auto& voxels) {
        regions[which].certain_size =
            0.5 * finest(image) *
            largest_cube(image, voxels, static_cast<std::uint32_t>(which), region_of);
      },
      image.voxels);
}

}  // namespace certet
