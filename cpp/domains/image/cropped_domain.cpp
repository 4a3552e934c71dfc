#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "certet/error.hpp"
#include "certet/image.hpp"

namespace certet {
namespace {

/// The part of a solid in a box of the world.
class CroppedDomain final : public PlacedDomain {
 public:
  CroppedDomain(std::unique_ptr<PlacedDomain> whole, const Bounds& box)
      : whole_(std::move(whole)), box_(box), lattice_(whole_->lattice()),
        border_(whole_->border().begin(), whole_->border().end()) {
    border_.push_back(BorderBox::along_world(frame(), box.low, box.high));
    crop_lattice();
  }

  void row(Coord3 first, std::span<Sign> out) const override {
    whole_->row(first, out);
    for (std::size_t i = 0; i < out.size(); ++i)
      if (out[i] != Sign::minus &&
          !inside(steps * (first + Coord3{2 * static_cast<std::int32_t>(i), 0, 0})))
        out[i] = Sign::minus;
  }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    whole_->at(positions, out);
    for (std::size_t i = 0; i < out.size(); ++i)
      if (out[i] != Sign::minus && !inside(positions[i])) out[i] = Sign::minus;
  }
  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    const Extent place = place_of(in_world(box));
    if (place == Extent::outside) return place;
    const Extent found = whole_->extent(box);
    return place == Extent::inside || found == Extent::outside ? found : Extent::mixed;
  }
  [[nodiscard]] bool even_points_tell_pieces() const override {
    return whole_->even_points_tell_pieces();
  }
  [[nodiscard]] std::span<const std::int32_t> labels() const override { return whole_->labels(); }
  void row_materials(Coord3 first, std::span<Material> out) const override {
    whole_->row_materials(first, out);
    for (std::size_t i = 0; i < out.size(); ++i)
      if (out[i] != 0 && !inside(steps * (first + Coord3{2 * static_cast<std::int32_t>(i), 0, 0})))
        out[i] = 0;
  }
  void materials_at(std::span<const Coord3> positions, std::span<Material> out) const override {
    whole_->materials_at(positions, out);
    for (std::size_t i = 0; i < out.size(); ++i)
      if (out[i] != 0 && !inside(positions[i])) out[i] = 0;
  }
  [[nodiscard]] std::optional<Material> material_of(const LatticeBox& box) const override {
    switch (place_of(in_world(box))) {
      case Extent::outside: return 0;
      case Extent::inside: return whole_->material_of(box);
      case Extent::mixed: break;
    }
    const std::optional<Material> found = whole_->material_of(box);
    return found == 0 ? found : std::nullopt;
  }
  /// That the box cuts a voxel off changes no label.
  void materials_of(std::span<const TetCorners> tets, std::span<Material> out) const override {
    whole_->materials_of(tets, out);
  }
  [[nodiscard]] std::span<const BorderBox> border() const override { return border_; }
  [[nodiscard]] bool is_sampled() const override { return whole_->is_sampled(); }
  [[nodiscard]] LabelNames names() const override { return whole_->names(); }
  [[nodiscard]] const Frame& frame() const override { return whole_->frame(); }
  [[nodiscard]] const Lattice& lattice() const override { return lattice_; }
  [[nodiscard]] double longest_side() const override {
    double longest = 0;
    for (std::size_t a = 0; a < 3; ++a)
      longest = std::max(longest, box_.high[a] - box_.low[a]);
    return std::min(longest, whole_->longest_side());
  }
  [[nodiscard]] std::uint64_t bytes() const override { return whole_->bytes(); }

 private:
  [[nodiscard]] bool inside(Coord3 position) const {
    const Point3 world = frame().world(position);
    for (std::size_t a = 0; a < 3; ++a)
      if (world[a] < box_.low[a] || world[a] > box_.high[a]) return false;
    return true;
  }

  /// How a box of the world lies to the one that is cropped to.
  [[nodiscard]] Extent place_of(const Bounds& world) const {
    bool within = true;
    for (std::size_t a = 0; a < 3; ++a) {
      if (world.high[a] < box_.low[a] || world.low[a] > box_.high[a]) return Extent::outside;
      within = within && world.low[a] > box_.low[a] && world.high[a] < box_.high[a];
    }
    return within ? Extent::inside : Extent::mixed;
  }

  /// A box around a lattice box, a little wider than rounding may move a corner.
  [[nodiscard]] Bounds in_world(const LatticeBox& box) const {
    Bounds world;
    world.low.fill(std::numeric_limits<double>::infinity());
    world.high.fill(-std::numeric_limits<double>::infinity());
    for (int corner = 0; corner < 8; ++corner) {
      const Point3 at = frame().world(steps * Coord3{corner & 1 ? box.high.x : box.low.x,
                                                     corner & 2 ? box.high.y : box.low.y,
                                                     corner & 4 ? box.high.z : box.low.z});
      for (std::size_t a = 0; a < 3; ++a) {
        world.low[a] = std::min(world.low[a], at[a] - 1e-9 * frame().size);
        world.high[a] = std::max(world.high[a], at[a] + 1e-9 * frame().size);
      }
    }
    return world;
  }

  /// Leaves out the cells that lie beyond the box, but for two, so that no point of
  /// the box is among the outermost.  The points stay where they are.
  void crop_lattice() {
    Point3 low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (int corner = 0; corner < 8; ++corner) {
      const Point3 at = frame().position({corner & 1 ? box_.high[0] : box_.low[0],
                                    corner & 2 ? box_.high[1] : box_.low[1],
                                    corner & 4 ? box_.high[2] : box_.low[2]});
      for (std::size_t a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], at[a]);
        high[a] = std::max(high[a], at[a]);
      }
    }
    std::int32_t* origin[3] = {&lattice_.origin.x, &lattice_.origin.y, &lattice_.origin.z};
    for (std::size_t a = 0; a < 3; ++a) {
      const double cells = lattice_.cells[a];
      const double first =
          std::clamp(std::floor((low[a] - *origin[a]) / 2) - 2, 0.0, cells);
      const double end = std::clamp(std::ceil((high[a] - *origin[a]) / 2) + 3, 0.0, cells);
      if (!(end > first))
        throw Error(ErrorCode::empty_domain, "the solid lies outside of the box to crop to");
      *origin[a] += 2 * static_cast<std::int32_t>(first);
      lattice_.cells[a] = static_cast<std::int32_t>(end - first);
    }
  }

  std::unique_ptr<PlacedDomain> whole_;
  Bounds box_;
  Lattice lattice_;
  std::vector<BorderBox> border_;
};

}  // namespace

std::unique_ptr<PlacedDomain> cropped_domain(std::unique_ptr<PlacedDomain> whole,
                                            const Bounds& box) {
  for (std::size_t a = 0; a < 3; ++a)
    if (!(box.low[a] < box.high[a]) || !std::isfinite(box.low[a]) || !std::isfinite(box.high[a]))
      throw Error(ErrorCode::bad_option, "the box to crop to is empty or not finite");
  return std::make_unique<CroppedDomain>(std::move(whole), box);
}

}  // namespace certet
