#include "fields_domain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "axis_table.hpp"
#include "certet/error.hpp"
#include "fields/field_frame.hpp"
#include "fields/label_fields.hpp"
#include "fields/labelling.hpp"
#include "fields/material_image.hpp"
#include "fields/mesh_correction.hpp"
#include "fields/node_fields.hpp"
#include "fields/parting.hpp"
#include "fields/region_volumes.hpp"
#include "geometry.hpp"
#include "placement.hpp"

namespace certet::fields {
namespace {

Sign sign_of_material(Material material) { return material == 0 ? Sign::minus : Sign::plus; }

/// How the points of a lattice lie to the centres of voxels.
enum class OnCentres {
  some,          ///< or none
  all,           ///< one at each, and others between
  one_per_voxel  ///< that of the even points there is no other
};

class FieldsDomain final : public InterfaceDomain {
 public:
  FieldsDomain(std::shared_ptr<const LabelFields> kept, std::shared_ptr<const NodeFields> nodes,
               const Placement& placement, OnCentres on_centres)
      : kept_(std::move(kept)),
        nodes_(std::move(nodes)),
        image_(kept_->image),
        fields_(*nodes_),
        placement_(placement),
        frame_(placement.axis),
        on_centres_(on_centres),
        labelling_(fields_,
                   on_centres == OnCentres::one_per_voxel ? Centres::unjoined
                                                          : Centres::as_fields_say,
                   !keeps_voxels()),
        along_x_(placement.lattice.origin.x, placement.lattice.cells[0],
                 [this](double x) { return frame_.along(0, x); }) {}

  [[nodiscard]] const Frame& frame() const override { return placement_.frame; }
  [[nodiscard]] const Lattice& lattice() const override { return placement_.lattice; }
  [[nodiscard]] double longest_side() const override { return placement_.longest_side; }
  [[nodiscard]] std::uint64_t bytes() const override { return image_.bytes() + fields_.bytes(); }
  [[nodiscard]] std::span<const BorderBox> border() const override { return placement_.border; }
  [[nodiscard]] bool is_sampled() const override { return true; }
  [[nodiscard]] LabelNames names() const override { return image_.image().names; }
  [[nodiscard]] std::span<const std::int32_t> labels() const override { return image_.labels(); }

  void row(Coord3 first, std::span<Sign> out) const override {
    std::vector<Material> materials(out.size());
    row_materials(first, materials);
    std::ranges::transform(materials, out.begin(), sign_of_material);
  }

  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = sign_of_material(material(positions[i]));
  }

  void row_materials(Coord3 first, std::span<Material> out) const override {
    FieldPoint point{{0, frame_.along(1, first.y), frame_.along(2, first.z)}};
    if (!frame_.covers(1, point.at[1]) || !frame_.covers(2, point.at[2]))
      return static_cast<void>(std::ranges::fill(out, 0));
    const bool tabled = along_x_.holds(first.x, out.size());
    const std::int64_t* table = tabled ? along_x_.from(first.x) : nullptr;
    BlockView block;
    std::int64_t block_from = -1;
    for (std::size_t i = 0; i < out.size(); ++i) {
      point.at[0] = tabled ? table[2 * i]
                           : frame_.along(0, first.x + 2.0 * static_cast<double>(i));
      if (!frame_.covers(0, point.at[0])) {
        out[i] = 0;
        continue;
      }
      const Cell cell = point.cell();
      if (cell[0] / block_cells != block_from) {
        block_from = cell[0] / block_cells;
        block = fields_.block(cell);
      }
      out[i] = labelling_.in_block(block, cell, point);
    }
  }

  void materials_at(std::span<const Coord3> positions, std::span<Material> out) const override {
    std::ranges::transform(positions, out.begin(), [this](Coord3 p) { return material(p); });
  }

  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    const auto only = material_of(box);
    return !only ? Extent::mixed : *only == 0 ? Extent::outside : Extent::inside;
  }

  [[nodiscard]] std::optional<Material> material_of(const LatticeBox& box) const override {
    CellBox cells;
    bool whole = true;
    const FieldExtent& extent = frame_.extent();
    const FieldPoint low = frame_.at_lattice(box.low), high = frame_.at_lattice(box.high);
    for (std::size_t a = 0; a < 3; ++a) {
      const auto [from, to] = std::minmax(low.at[a], high.at[a]);
      if (to < extent.low[a] || from > extent.high[a]) return 0;
      whole = whole && from >= extent.low[a] && to <= extent.high[a];
      cells.low[a] = std::max(from, extent.low[a]) >> point_bits;
      cells.high[a] = std::min(to, extent.high[a]) >> point_bits;
    }
    const auto only = fields_.only_material(cells);
    return whole || only == 0 ? only : std::nullopt;
  }

  void part(std::span<const PartedEdge> edges, std::span<std::uint16_t> out) const override {
    Parting parting(fields_, frame_.extent(), !keeps_voxels());
    std::ranges::transform(edges, out.begin(), [&](const PartedEdge& edge) {
      const FieldPoint first = frame_.at_lattice(edge.first);
      const Material of_first = edge.of_first != 0 ? edge.of_first : labelling_(first);
      return parting({first, frame_.at_lattice(edge.last), of_first, edge.of_last});
    });
  }

  [[nodiscard]] bool keeps_voxels() const override {
    return on_centres_ != OnCentres::some;
  }

  /// Then even points are the voxels: `VoxelPiecesKept` of the certificate.
  [[nodiscard]] bool even_points_tell_pieces() const override {
    return on_centres_ == OnCentres::one_per_voxel;
  }

  [[nodiscard]] std::vector<RegionVolume> volumes(const Context& context) const override {
    const auto counts = region_volumes(fields_, image_.size(), !keeps_voxels(), context);
    std::vector<RegionVolume> volumes;
    for (std::size_t l = 0; l < image_.labels().size(); ++l)
      volumes.push_back({image_.labels()[l], image_.voxels()[l],
                         static_cast<double>(counts[l + 1]) / 64});
    return volumes;
  }

 private:
  /// `position` is in steps.
  [[nodiscard]] Material material(Coord3 position) const {
    const FieldPoint point = frame_.at(position);
    return frame_.extent().contains(point) ? labelling_(point) : 0;
  }

  std::shared_ptr<const LabelFields> kept_;
  std::shared_ptr<const NodeFields> nodes_;
  const MaterialImage& image_;
  const NodeFields& fields_;
  Placement placement_;
  FieldFrame frame_;
  OnCentres on_centres_;
  Labelling labelling_;
  AxisTable<std::int64_t> along_x_;  ///< in nodes
};

/// How many even points there are per voxel along an axis; 0 where that is no whole
/// number.
double points_per_voxel(double spacing, double size) {
  const double points = std::round(spacing / size);
  return std::abs(points * size - spacing) <= 1e-9 * spacing ? points : 0;
}

void refuse_sigma(const Image& image, double sigma) {
  if (!(sigma > 0 && std::isfinite(sigma)))
    throw Error(ErrorCode::bad_option, "the smoothing must be a positive number");
  const double finest = *std::ranges::min_element(image.spacing);
  if (sigma > greatest_sigma * finest)
    throw Error(ErrorCode::bad_option, "the smoothing of '" + image.name +
                                           "' must be at most 4 voxels along every axis");
}

OnCentres on_centres(const Image& image, double size) {
  bool all = true, one_per_voxel = true;
  for (const double spacing : image.spacing) {
    const double points = points_per_voxel(spacing, size);
    all = all && points >= 1;
    one_per_voxel = one_per_voxel && points == 1;
  }
  return one_per_voxel ? OnCentres::one_per_voxel : all ? OnCentres::all : OnCentres::some;
}

Rules rules_of(const Image& image, const InterfaceSmoothing& smoothing) {
  Rules rules;
  if (!smoothing.sigma) return rules;
  rules.slope_treads = false;  // who asks for little smoothing wants the voxels' steps
  check_geometry(image);
  refuse_sigma(image, *smoothing.sigma);
  for (std::size_t a = 0; a < 3; ++a)
    rules.taps[a] = gaussian_taps(*smoothing.sigma / image.spacing[a]);
  return rules;
}

}  // namespace

std::unique_ptr<InterfaceDomain> fields_domain(std::shared_ptr<const Image> image,
                                              std::vector<LabelRange> labels,
                                              const ImageLattice& lattice, const Rules& rules,
                                              const Context& context) {
  return interface_domain(
      std::make_shared<const LabelFields>(std::move(image), std::move(labels), rules, context),
      lattice, context);
}

}  // namespace certet::fields

namespace certet {

std::shared_ptr<const LabelFields> label_fields(std::shared_ptr<const Image> image,
                                                std::vector<LabelRange> labels,
                                                const InterfaceSmoothing& smoothing,
                                                const Context& context) {
  const fields::Rules rules = fields::rules_of(*image, smoothing);
  return std::make_shared<const LabelFields>(std::move(image), std::move(labels), rules, context);
}

std::unique_ptr<InterfaceDomain> interface_domain(std::shared_ptr<const LabelFields> fields,
                                                 const ImageLattice& lattice,
                                                 const Context& context) {
  const fields::MaterialImage& materials = fields->image;
  const Placement placement = place(materials.image(), materials.bounds(), lattice, 0);
  const auto on_centres = fields::on_centres(materials.image(), placement.frame.size);
  const auto domain_of = [&](std::shared_ptr<const fields::NodeFields> nodes) {
    return std::make_unique<fields::FieldsDomain>(fields, std::move(nodes), placement, on_centres);
  };
  return domain_of(fields::corrected_by_mesh(fields, placement, domain_of, context));
}

std::unique_ptr<InterfaceDomain> interface_domain(std::shared_ptr<const Image> image,
                                                 std::vector<LabelRange> labels,
                                                 const ImageLattice& lattice,
                                                 const InterfaceSmoothing& smoothing,
                                                 const Context& context) {
  return interface_domain(label_fields(std::move(image), std::move(labels), smoothing, context),
                          lattice, context);
}

}  // namespace certet
