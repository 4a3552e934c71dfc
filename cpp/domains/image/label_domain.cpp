#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "axis_table.hpp"
#include "certet/error.hpp"
#include "certet/image.hpp"
#include "geometry.hpp"
#include "label_set.hpp"
#include "material_table.hpp"
#include "voxel_mask.hpp"

namespace certet {
namespace {

/// Labels come in runs, so the last answer is usually the next one.
template <class T>
void mark_row(const T* voxels, std::int64_t count, const LabelSet& set,
              std::uint64_t* bits, LabelCollector& labels) {
  std::uint64_t hit = 0;
  for (std::int64_t x = 0; x < count; ++x) {
    if (x == 0 || voxels[x] != voxels[x - 1]) {
      hit = set.contains(static_cast<std::int64_t>(voxels[x]));
      if (hit != 0) labels.add(static_cast<std::int64_t>(voxels[x]));
    }
    bits[x >> 6] |= hit << (x & 63);
  }
}

template <class T>
VoxelMask mark(const Image& image, const Buffer<T>& voxels, const LabelSet& set,
               LabelCollector& labels) {
  VoxelMask mask(image.size);
  const T* row = voxels.data();
  for (std::int64_t z = 0; z < image.size[2]; ++z)
    for (std::int64_t y = 0; y < image.size[1]; ++y, row += image.size[0])
      mark_row(row, image.size[0], set, mask.row(y, z), labels);
  mask.summarise();
  return mask;
}

template <class T>
class LabelDomain final : public PlacedDomain {
 public:
  LabelDomain(std::shared_ptr<const Image> image, VoxelMask mask, MaterialTable table,
              const Placement& placement)
      : image_(std::move(image)),
        size_(image_->size),
        voxels_(std::get<Buffer<T>>(image_->voxels)),
        mask_(std::move(mask)),
        table_(std::move(table)),
        placement_(placement),
        along_x_(placement.lattice.origin.x, placement.lattice.cells[0],
                 [this](double x) { return column(x); }),
        eighths_{eighths(0, placement.lattice.origin.x, {1, 1}),
                 eighths(1, placement.lattice.origin.y, {size_[0], mask_.row_bits()}),
                 eighths(2, placement.lattice.origin.z,
                         {size_[0] * size_[1], mask_.row_bits() * size_[1]})} {}

  [[nodiscard]] const Frame& frame() const override { return placement_.frame; }
  [[nodiscard]] const Lattice& lattice() const override { return placement_.lattice; }

  [[nodiscard]] double longest_side() const override { return placement_.longest_side; }
  [[nodiscard]] std::uint64_t bytes() const override {
    return voxels_.size() * sizeof(T) + mask_.bytes() + table_.bytes();
  }

  void row(Coord3 first, std::span<Sign> out) const override {
    const std::int64_t y = placement_.axis[1].nearest(first.y);
    const std::int64_t z = placement_.axis[2].nearest(first.z);
    if (y < 0 || z < 0) return std::fill(out.begin(), out.end(), Sign::minus);
    const std::uint64_t* bits = mask_.row(y, z);
    if (!along_x_.holds(first.x, out.size())) {
      for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = sign(bits, column(first.x + 2.0 * static_cast<double>(i)));
      return;
    }
    const std::int64_t* x = along_x_.from(first.x);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = sign(bits, x[2 * i]);
  }

  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = voxel(positions[i]) < 0 ? Sign::minus : Sign::plus;
  }

  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    const auto reach = voxels_within(placement_, box, false);
    if (!reach) return Extent::outside;
    const Extent found = mask_.extent(reach->voxels);
    return found == Extent::inside && !reach->whole ? Extent::mixed : found;
  }

  /// Where no voxel is narrower than a long edge, even points are joined by edges exactly
  /// as voxels are by faces: `VoxelPiecesKept` of the certificate.
  [[nodiscard]] bool even_points_tell_pieces() const override {
    return placement_.frame.size <= *std::ranges::min_element(image_->spacing);
  }

  [[nodiscard]] std::span<const BorderBox> border() const override { return placement_.border; }
  [[nodiscard]] bool is_sampled() const override { return true; }
  [[nodiscard]] LabelNames names() const override { return image_->names; }

  [[nodiscard]] std::span<const std::int32_t> labels() const override { return table_.labels(); }

  void row_materials(Coord3 first, std::span<Material> out) const override {
    const std::int64_t y = placement_.axis[1].nearest(first.y);
    const std::int64_t z = placement_.axis[2].nearest(first.z);
    LastMaterial material(*this);
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = material(index_if_chosen(
          placement_.axis[0].nearest(first.x + 2.0 * static_cast<double>(i)), y, z));
  }

  void materials_at(std::span<const Coord3> positions, std::span<Material> out) const override {
    LastMaterial material(*this);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = material(voxel(positions[i]));
  }

  [[nodiscard]] std::optional<Material> material_of(const LatticeBox& box) const override {
    const auto reach = voxels_within(placement_, box, false);
    if (!reach) return 0;
    switch (mask_.extent(reach->voxels)) {
      case Extent::outside: return 0;
      case Extent::inside: return reach->whole ? material_of_voxels(reach->voxels) : std::nullopt;
      case Extent::mixed: break;
    }
    return std::nullopt;
  }

  void materials_of(std::span<const TetCorners> tets, std::span<Material> out) const override {
    constexpr std::size_t batch = 16;  // a cell or two, which often are of one label
    for (std::size_t begin = 0; begin < out.size(); begin += batch) {
      const std::size_t count = std::min(batch, out.size() - begin);
      find_materials(tets.subspan(begin, count), out.subspan(begin, count));
    }
  }

 private:
  /// Materials of voxels; labels come in runs.
  class LastMaterial {
   public:
    explicit LastMaterial(const LabelDomain& domain) : domain_(domain) {}
    /// Of the voxel with this index; 0 if it is negative.
    Material operator()(std::int64_t voxel) {
      if (voxel < 0) return 0;
      const T label = domain_.voxels_[static_cast<std::size_t>(voxel)];
      if (found_ == 0 || label != last_) {
        last_ = label;
        found_ = domain_.table_.of(static_cast<std::int64_t>(label));
      }
      return found_;
    }

   private:
    const LabelDomain& domain_;
    T last_{};
    Material found_ = 0;
  };

  /// That of all voxels of a box, which are chosen.
  [[nodiscard]] std::optional<Material> material_of_voxels(const VoxelBox& box) const {
    const auto& low = box.low;
    const auto& high = box.high;
    const auto index = [&](std::int64_t y, std::int64_t z) {
      return static_cast<std::size_t>((z * size_[1] + y) * size_[0] + low[0]);
    };
    const T label = voxels_[index(low[1], low[2])];
    const auto length = static_cast<std::size_t>(high[0] - low[0] + 1);
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (const T other : std::span(voxels_.data() + index(y, z), length))
          if (other != label) return std::nullopt;
    return table_.of(static_cast<std::int64_t>(label));
  }

  static Sign sign(const std::uint64_t* bits, std::int64_t x) {
    static_assert(static_cast<int>(Sign::plus) == 2 && static_cast<int>(Sign::minus) == 0);
    return static_cast<Sign>(VoxelMask::test(bits, x) << 1);
  }

  /// Four times a position in steps: a sum over the corners of a tetrahedron,
  /// which is four times its centroid.
  using Sum = std::array<std::int64_t, 3>;

  static Sum sum_of(const TetCorners& corners) {
    const auto& [a, b, c, d] = corners;
    return {std::int64_t{a.x} + b.x + c.x + d.x, std::int64_t{a.y} + b.y + c.y + d.y,
            std::int64_t{a.z} + b.z + c.z + d.z};
  }

  /// Where a voxel stands in `voxels_`, and its bit in the mask; a sum over the
  /// three axes.  Negative beyond the image, whatever is added.
  struct Place {
    std::int64_t voxel, bit;
  };
  using PlaceTable = AxisTable<Place>;

  [[nodiscard]] PlaceTable eighths(std::size_t axis, std::int32_t origin, Place stride) const {
    return {8 * origin, 8 * placement_.lattice.cells[axis], [&, axis, stride](double at) {
              const std::int64_t voxel = placement_.axis[axis].nearest(0.125 * at);
              constexpr std::int64_t beyond = std::numeric_limits<std::int64_t>::min() / 4;
              return voxel < 0 ? Place{beyond, beyond}
                               : Place{voxel * stride.voxel, voxel * stride.bit};
            }};
  }

  /// Away from the surface, and everywhere with midpoint cuts, centroids are at
  /// eighths of lattice units, which are tabled.
  void find_materials(std::span<const TetCorners> tets, std::span<Material> out) const {
    std::array<Sum, 16> sums;
    SumRange range;
    for (std::size_t i = 0; i < tets.size(); ++i) range.add(sums[i] = sum_of(tets[i]));
    if (const Material same = material_within(range); same != 0) {
      std::ranges::fill(out, same);
      return;
    }
    LastMaterial material(*this);
    const bool tabled = all_tabled(range);
    for (std::size_t i = 0; i < tets.size(); ++i) {
      const std::int64_t voxel =
          tabled && at_eighths(sums[i]) ? tabled_voxel(sums[i]) : chosen_voxel(sums[i]);
      out[i] = material(voxel < 0 ? voxel_of_nearest_corner(tets[i], sums[i]) : voxel);
    }
  }

  static constexpr int eighth_bits = step_bits - 1;  ///< of four times an eighth

  static bool at_eighths(const Sum& sum) {
    constexpr std::int64_t fraction = (std::int64_t{1} << eighth_bits) - 1;
    return ((sum[0] | sum[1] | sum[2]) & fraction) == 0;
  }

  /// A box of centroids.
  struct SumRange {
    Sum low{std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::max(),
            std::numeric_limits<std::int64_t>::max()};
    Sum high{std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::min(),
             std::numeric_limits<std::int64_t>::min()};
    void add(const Sum& sum) {
      for (std::size_t a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], sum[a]);
        high[a] = std::max(high[a], sum[a]);
      }
    }
  };

  /// The material of all centroids of a box whose voxels all have one chosen label;
  /// else 0.  From corner to corner voxels follow each other as centroids do.
  [[nodiscard]] Material material_within(const SumRange& range) const {
    constexpr std::int64_t most_voxels = 64;
    VoxelBox box;
    std::int64_t count = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::int64_t one = placement_.axis[a].nearest(lattice_coordinate(range.low[a]));
      const std::int64_t other = placement_.axis[a].nearest(lattice_coordinate(range.high[a]));
      if (one < 0 || other < 0) return 0;
      std::tie(box.low[a], box.high[a]) = std::minmax(one, other);
      count *= box.high[a] - box.low[a] + 1;
      if (count > most_voxels) return 0;
    }
    if (!mask_.test(box.low[0], box.low[1], box.low[2])) return 0;
    return material_of_voxels(box).value_or(0);
  }

  /// Whether the tables reach as far as these centroids.
  [[nodiscard]] bool all_tabled(const SumRange& range) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (!eighths_[a].holds(static_cast<std::int32_t>(range.low[a] >> eighth_bits), 1) ||
          !eighths_[a].holds(static_cast<std::int32_t>(range.high[a] >> eighth_bits), 1))
        return false;
    return true;
  }

  /// As `chosen_voxel`, at eighths that are in the tables.
  [[nodiscard]] std::int64_t tabled_voxel(const Sum& sum) const {
    const Place& x = *eighths_[0].from(static_cast<std::int32_t>(sum[0] >> eighth_bits));
    const Place& y = *eighths_[1].from(static_cast<std::int32_t>(sum[1] >> eighth_bits));
    const Place& z = *eighths_[2].from(static_cast<std::int32_t>(sum[2] >> eighth_bits));
    const std::int64_t bit = x.bit + y.bit + z.bit;
    return bit < 0 || !mask_.test(bit) ? -1 : x.voxel + y.voxel + z.voxel;
  }

  /// Of one coordinate of a centroid.  Both factors are exact, for the sum fits 35 bits.
  static double lattice_coordinate(std::int64_t sum) {
    return 0.25 / steps * static_cast<double>(sum);
  }

  /// The index of the voxel at a centroid, or -1 where it is not chosen.
  [[nodiscard]] std::int64_t chosen_voxel(const Sum& sum) const {
    return chosen_voxel(lattice_coordinate(sum[0]), lattice_coordinate(sum[1]),
                        lattice_coordinate(sum[2]));
  }

  [[nodiscard]] std::int64_t column(double x) const {
    const std::int64_t voxel = placement_.axis[0].nearest(x);
    return voxel < 0 ? mask_.outside() : voxel;
  }

  /// The index of the voxel at a lattice position, or -1 where it is not chosen.
  [[nodiscard]] std::int64_t chosen_voxel(double lx, double ly, double lz) const {
    return index_if_chosen(placement_.axis[0].nearest(lx), placement_.axis[1].nearest(ly),
                           placement_.axis[2].nearest(lz));
  }
  [[nodiscard]] std::int64_t index_if_chosen(std::int64_t x, std::int64_t y,
                                             std::int64_t z) const {
    if (x < 0 || y < 0 || z < 0 || !mask_.test(x, y, z)) return -1;
    return (z * size_[1] + y) * size_[0] + x;
  }

  /// `position` is in steps.
  [[nodiscard]] std::int64_t voxel(Coord3 position) const {
    constexpr double unit = 1.0 / steps;
    return chosen_voxel(unit * position.x, unit * position.y, unit * position.z);
  }

  /// Every tetrahedron of the mesh has a corner inside, which is a lattice
  /// point that was not warped, so that there always is one.
  [[nodiscard]] std::int64_t voxel_of_nearest_corner(const TetCorners& corners,
                                                     const Sum& sum) const {
    std::int64_t best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (const Coord3 corner : corners) {
      const Sum four{4 * std::int64_t{corner.x}, 4 * std::int64_t{corner.y},
                     4 * std::int64_t{corner.z}};
      const std::int64_t candidate = chosen_voxel(four);
      double distance = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        const auto difference = static_cast<double>(four[a] - sum[a]);
        distance += difference * difference;
      }
      if (candidate < 0 || distance >= least) continue;
      best = candidate;
      least = distance;
    }
    return best;
  }

  std::shared_ptr<const Image> image_;
  std::array<std::int64_t, 3> size_;
  const Buffer<T>& voxels_;  ///< the image's
  VoxelMask mask_;
  MaterialTable table_;
  Placement placement_;
  AxisTable<std::int64_t> along_x_;
  std::array<PlaceTable, 3> eighths_;  ///< by eighths of lattice units
};

}  // namespace

std::unique_ptr<PlacedDomain> label_domain(std::shared_ptr<const Image> image,
                                          std::vector<LabelRange> labels,
                                          const ImageLattice& lattice) {
  const Image& scan = *image;
  check_geometry(scan);
  const bool all = labels.empty();
  const LabelSet set(std::move(labels));
  return std::visit(
      [&]<class T>(const Buffer<T>& voxels) -> std::unique_ptr<PlacedDomain> {
        if constexpr (std::is_floating_point_v<T>) {
          refuse_levels(scan);
        } else {
          refuse_wide_labels(scan, voxels, set);
          LabelCollector found;
          VoxelMask mask = mark(scan, voxels, set, found);
          if (mask.bounds().high[0] < 0) refuse_unlabelled(scan, all);
          const Placement placement = place(
              scan, mask.bounds(), lattice, lattice.walls_halfway ? 0.25 : 0.4375);
          return std::make_unique<LabelDomain<T>>(image, std::move(mask),
                                                  MaterialTable(found.finish()), placement);
        }
      },
      scan.voxels);
}

}  // namespace certet
