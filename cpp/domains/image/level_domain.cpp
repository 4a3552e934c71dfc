#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

#include "axis_table.hpp"
#include "certet/error.hpp"
#include "certet/image.hpp"
#include "geometry.hpp"
#include "placement.hpp"
#include "voxel_place.hpp"

namespace certet {
namespace {

/// The two voxels that a position lies between, as stored, and how far it is
/// from the first to the second.
struct Between {
  std::int64_t first = -1, second = -1;  ///< -1: beyond the image
  double weight = 0;
};

Between between(const VoxelAxis& axis, double lattice) {
  const double at = axis.forward(lattice);
  if (!axis.covers(at)) return {};
  const double last = static_cast<double>(axis.count - 1);
  const double cell = std::clamp(std::floor(at), 0.0, std::max(last - 1, 0.0));
  const auto first = static_cast<std::int64_t>(cell);
  return {axis.stored(first), axis.stored(std::min(first + 1, axis.count - 1)),
          std::clamp(at - cell, 0.0, 1.0)};
}

double mix(double a, double b, double weight) { return a + weight * (b - a); }

/// Least and greatest voxel of every block of 8 x 8 x 8.
class BlockRanges {
 public:
  template <class T>
  BlockRanges(const std::array<std::int64_t, 3>& size, const Buffer<T>& voxels) {
    for (std::size_t a = 0; a < 3; ++a) blocks_[a] = ((size[a] - 1) >> 3) + 1;
    ranges_.resize(static_cast<std::size_t>(blocks_[0] * blocks_[1] * blocks_[2]));
    const T* voxel = voxels.data();
    for (std::int64_t z = 0; z < size[2]; ++z)
      for (std::int64_t y = 0; y < size[1]; ++y)
        for (std::int64_t x = 0; x < size[0]; ++x, ++voxel)
          ranges_[block(x >> 3, y >> 3, z >> 3)].add(static_cast<double>(*voxel));
  }

  [[nodiscard]] std::uint64_t bytes() const { return ranges_.size() * sizeof(Range); }

  struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void add(double value) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  };

  /// Of all voxels in the blocks that a box touches.
  [[nodiscard]] Range range(const VoxelBox& box, double level) const {
    Range all;
    for (std::int64_t z = box.low[2] >> 3; z <= box.high[2] >> 3; ++z)
      for (std::int64_t y = box.low[1] >> 3; y <= box.high[1] >> 3; ++y)
        for (std::int64_t x = box.low[0] >> 3; x <= box.high[0] >> 3; ++x) {
          const Range& one = ranges_[block(x, y, z)];
          all.low = std::min(all.low, one.low);
          all.high = std::max(all.high, one.high);
          if (all.low <= level && level <= all.high) return all;  // nothing to be said
        }
    return all;
  }

 private:
  [[nodiscard]] std::size_t block(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return static_cast<std::size_t>((z * blocks_[1] + y) * blocks_[0] + x);
  }
  std::array<std::int64_t, 3> blocks_;
  std::vector<Range> ranges_;
};

/// The voxels above the level, and those next to them that the interpolated
/// solid may reach into.
template <class T>
VoxelBox reach_above(const Image& image, const Buffer<T>& voxels, double level) {
  VoxelBox box;
  box.low.fill(std::numeric_limits<std::int64_t>::max());
  box.high.fill(-1);
  const T* voxel = voxels.data();
  for (std::int64_t z = 0; z < image.size[2]; ++z)
    for (std::int64_t y = 0; y < image.size[1]; ++y)
      for (std::int64_t x = 0; x < image.size[0]; ++x, ++voxel) {
        if (!(static_cast<double>(*voxel) > level)) continue;
        const std::int64_t at[3] = {x, y, z};
        for (std::size_t a = 0; a < 3; ++a) {
          box.low[a] = std::min(box.low[a], at[a]);
          box.high[a] = std::max(box.high[a], at[a]);
        }
      }
  if (box.high[0] < 0) {
    std::ostringstream sentence;
    sentence << "no voxel of '" << image.name << "' is above the level " << level
             << "; the greatest is " << static_cast<double>(*std::ranges::max_element(voxels));
    throw Error(ErrorCode::empty_domain, sentence.str());
  }
  for (std::size_t a = 0; a < 3; ++a) {
    box.low[a] = std::max<std::int64_t>(box.low[a] - 1, 0);
    box.high[a] = std::min(box.high[a] + 1, image.size[a] - 1);
  }
  return box;
}

/// So that the difference of two voxels is a number as well.
template <class T>
void refuse_wild_voxels(const Image& image, const Buffer<T>& voxels) {
  constexpr double greatest = 1e300;
  if constexpr (std::is_floating_point_v<T>) {
    std::uint64_t nan = 0, wild = 0, first = 0;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      if (std::abs(double{voxels[i]}) <= greatest) continue;
      if (wild++ == 0) first = i;
      nan += std::isnan(voxels[i]) ? 1 : 0;
    }
    if (wild == 0) return;
    const std::string verb = wild == 1 ? " voxel that is " : " voxels that are ";
    throw Error(ErrorCode::bad_input,
                "'" + image.name + "' has " + std::to_string(wild) + verb +
                    (nan == wild ? "NaN"
                     : nan == 0  ? "infinite or beyond 1e300"
                                 : "NaN (" + std::to_string(nan) + "), infinite or beyond 1e300") +
                    (wild == 1 ? ", at " : ", the first at ") + voxel_place(image, first) +
                    (nan == wild ? ": --nan V reads them as the value V" : ""));
  }
}

template <class T>
class LevelDomain final : public PlacedDomain {
 public:
  LevelDomain(std::shared_ptr<const Image> image, double level, const Placement& placement)
      : image_(std::move(image)),
        size_(image_->size),
        voxels_(std::get<Buffer<T>>(image_->voxels)),
        level_(level),
        placement_(placement),
        ranges_(size_, voxels_),
        along_x_(placement.lattice.origin.x, placement.lattice.cells[0],
                 [this](double x) { return between(placement_.axis[0], x); }) {}

  [[nodiscard]] const Frame& frame() const override { return placement_.frame; }
  [[nodiscard]] const Lattice& lattice() const override { return placement_.lattice; }
  [[nodiscard]] std::span<const BorderBox> border() const override { return placement_.border; }
  [[nodiscard]] bool is_sampled() const override { return true; }
  [[nodiscard]] double longest_side() const override { return placement_.longest_side; }
  [[nodiscard]] std::uint64_t bytes() const override {
    return voxels_.size() * sizeof(T) + ranges_.bytes();
  }

  void row(Coord3 first, std::span<Sign> out) const override {
    const Between y = between(placement_.axis[1], first.y);
    const Between z = between(placement_.axis[2], first.z);
    if (y.first < 0 || z.first < 0)
      return std::fill(out.begin(), out.end(), Sign::minus);
    Columns columns(*this, y, z);
    const bool known = along_x_.holds(first.x, out.size());
    const Between* table = known ? along_x_.from(first.x) : nullptr;
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = columns.sign(known ? table[2 * i]
                                  : between(placement_.axis[0],
                                            first.x + 2.0 * static_cast<double>(i)));
  }

  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    constexpr double unit = 1.0 / steps;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const Between y = between(placement_.axis[1], unit * positions[i].y);
      const Between z = between(placement_.axis[2], unit * positions[i].z);
      out[i] = y.first < 0 || z.first < 0
                   ? Sign::minus
                   : Columns(*this, y, z).sign(
                         between(placement_.axis[0], unit * positions[i].x));
    }
  }

  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    const auto reach = voxels_within(placement_, box, true);
    if (!reach) return Extent::outside;
    const auto range = ranges_.range(reach->voxels, level_);
    // Interpolation may overshoot its corners by a rounding or two.
    const double rounding = 1e-12 * (std::abs(range.low) + std::abs(range.high));
    if (!std::isfinite(rounding) || !std::isfinite(range.high - range.low))
      return Extent::mixed;
    if (range.high < level_ - rounding) return Extent::outside;
    if (range.low > level_ + rounding && reach->whole) return Extent::inside;
    return Extent::mixed;
  }

 private:
  /// The image along x at given y and z.  Neighbouring lattice points share
  /// voxel columns, so the last two are kept.
  class Columns {
   public:
    Columns(const LevelDomain& domain, const Between& y, const Between& z)
        : y_weight_(y.weight), z_weight_(z.weight), level_(domain.level_) {
      const auto row = [&](std::int64_t iy, std::int64_t iz) {
        return domain.voxels_.data() +
               static_cast<std::size_t>((iz * domain.size_[1] + iy) * domain.size_[0]);
      };
      rows_ = {row(y.first, z.first), row(y.second, z.first), row(y.first, z.second),
               row(y.second, z.second)};
    }

    Sign sign(const Between& x) {
      if (x.first < 0) return Sign::minus;
      if (x.first != kept_) {
        first_ = column(x.first);
        second_ = column(x.second);
        kept_ = x.first;
      }
      return sign_of_level(level_ - mix(first_, second_, x.weight));
    }

   private:
    [[nodiscard]] double column(std::int64_t x) const {
      const auto value = [&](std::size_t r) { return static_cast<double>(rows_[r][x]); };
      return mix(mix(value(0), value(1), y_weight_), mix(value(2), value(3), y_weight_),
                 z_weight_);
    }

    std::array<const T*, 4> rows_;
    double y_weight_, z_weight_, level_;
    std::int64_t kept_ = -1;
    double first_ = 0, second_ = 0;
  };

  std::shared_ptr<const Image> image_;
  std::array<std::int64_t, 3> size_;
  const Buffer<T>& voxels_;  ///< the image's
  double level_;
  Placement placement_;
  BlockRanges ranges_;
  AxisTable<Between> along_x_;
};

}  // namespace

std::unique_ptr<PlacedDomain> level_domain(std::shared_ptr<const Image> image, double level,
                                          const ImageLattice& lattice) {
  const Image& scan = *image;
  check_geometry(scan);
  if (!std::isfinite(level))
    throw Error(ErrorCode::bad_option, "the level must be a finite number");
  return std::visit(
      [&]<class T>(const Buffer<T>& voxels) -> std::unique_ptr<PlacedDomain> {
        refuse_wild_voxels(scan, voxels);
        const Placement placement = place(scan, reach_above(scan, voxels, level), lattice, 0.25);
        return std::make_unique<LevelDomain<T>>(image, level, placement);
      },
      scan.voxels);
}

}  // namespace certet
