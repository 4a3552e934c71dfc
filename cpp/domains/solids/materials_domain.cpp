#include "certet/materials_domain.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "certet/error.hpp"
#include "strengths.hpp"
#include "united.hpp"

namespace certet {
namespace {

Bounds around(const std::vector<NamedSolid>& solids) {
  Bounds all = solids.front().solid.bounds;
  for (const NamedSolid& one : solids) all = certet::around(all, one.solid.bounds);
  return all;
}

std::vector<std::string> names_of(const std::vector<NamedSolid>& solids) {
  std::vector<std::string> names;
  for (const NamedSolid& one : solids) names.push_back(one.name);
  return names;
}

LatticeBox box_of_row(Coord3 first, std::size_t points) {
  return {first, first + Coord3{2 * (static_cast<std::int32_t>(points) - 1), 0, 0}};
}

class MaterialsDomain final : public PlacedDomain {
 public:
  MaterialsDomain(const std::vector<NamedSolid>& solids, std::vector<Material> strongest,
                  const Bounds& bounds, const MaterialsLattice& lattice)
      : strongest_(std::move(strongest)),
        strength_(solids.size() + 1, 0),
        names_(names_of(solids)),
        side_(certet::longest_side(bounds)),
        around_(lattice_around(bounds, lattice.size, lattice.margin)) {
    for (std::size_t n = 0; n < strongest_.size(); ++n)
      strength_[static_cast<std::size_t>(strongest_[n])] = strongest_.size() - n;
    for (const NamedSolid& one : solids) {
      solids_.push_back(one.solid.on(around_));
      labels_.push_back(static_cast<std::int32_t>(solids_.size()));
      const std::span<const BorderBox> cut_off = solids_.back()->border();
      border_.insert(border_.end(), cut_off.begin(), cut_off.end());
    }
  }

  [[nodiscard]] const Frame& frame() const override { return around_.frame; }
  [[nodiscard]] const Lattice& lattice() const override { return around_.lattice; }
  [[nodiscard]] double longest_side() const override { return side_; }
  [[nodiscard]] std::uint64_t bytes() const override {
    std::uint64_t all = 0;
    for (const auto& solid : solids_) all += solid->bytes();
    return all;
  }
  [[nodiscard]] std::span<const std::int32_t> labels() const override { return labels_; }
  [[nodiscard]] std::span<const BorderBox> border() const override { return border_; }
  [[nodiscard]] LabelNames names() const override {
    LabelNames names;
    for (std::size_t n = 0; n < labels_.size(); ++n) names.emplace(labels_[n], names_[n]);
    return names;
  }

  void row(Coord3 first, std::span<Sign> out) const override {
    unite(out, box_of_row(first, out.size()),
          [&](const Domain& solid, std::span<Sign> signs) { solid.row(first, signs); });
  }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    unite(out, std::nullopt,
          [&](const Domain& solid, std::span<Sign> signs) { solid.at(positions, signs); });
  }
  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    Extent found = Extent::outside;
    for (const auto& solid : solids_) {
      const Extent one = solid->extent(box);
      if (one == Extent::inside) return Extent::inside;
      if (one == Extent::mixed) found = Extent::mixed;
    }
    return found;
  }

  void row_materials(Coord3 first, std::span<Material> out) const override {
    choose(out, box_of_row(first, out.size()),
           [&](const Domain& solid, std::span<Sign> signs) { solid.row(first, signs); });
  }
  void materials_at(std::span<const Coord3> positions, std::span<Material> out) const override {
    choose(out, std::nullopt,
           [&](const Domain& solid, std::span<Sign> signs) { solid.at(positions, signs); });
  }
  [[nodiscard]] std::optional<Material> material_of(const LatticeBox& box) const override {
    for (const Material material : strongest_) {
      const Extent one = solid(material).extent(box);
      if (one == Extent::inside) return material;
      if (one == Extent::mixed) return std::nullopt;
    }
    return 0;
  }

  void part(std::span<const PartedEdge> edges, std::span<std::uint16_t> out) const override {
    std::vector<std::size_t> of_solid;
    for (const Material material : strongest_) {
      collect(edges, material, of_solid);
      if (!of_solid.empty()) leave(solid(material), material, edges, of_solid, out);
    }
    collect(edges, 0, of_solid);
    if (!of_solid.empty()) leave_all(edges, of_solid, out);
  }

 private:
  [[nodiscard]] const Domain& solid(Material material) const {
    return *solids_[static_cast<std::size_t>(material - 1)];
  }

  [[nodiscard]] Material stronger_of(const PartedEdge& edge) const {
    const auto strength = [&](Material m) { return strength_[static_cast<std::size_t>(m)]; };
    return strength(edge.of_first) > strength(edge.of_last) ? edge.of_first : edge.of_last;
  }

  void collect(std::span<const PartedEdge> edges, Material stronger,
               std::vector<std::size_t>& which) const {
    which.clear();
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (stronger_of(edges[e]) == stronger) which.push_back(e);
  }

  /// Some of the edges have their stronger end, which the others are outside of, in a solid:
  /// where they leave it.
  static void leave(const Domain& solid, Material material, std::span<const PartedEdge> edges,
                    std::span<const std::size_t> which, std::span<std::uint16_t> out) {
    std::vector<PartedEdge> outwards;
    for (const std::size_t e : which) {
      const bool forward = edges[e].of_first == material;
      outwards.push_back({forward ? edges[e].first : edges[e].last,
                          forward ? edges[e].last : edges[e].first, 0, 1});
    }
    std::vector<std::uint16_t> cuts(outwards.size());
    solid.part(outwards, cuts);
    for (std::size_t n = 0; n < which.size(); ++n) {
      const bool forward = edges[which[n]].of_first == material;
      out[which[n]] = forward ? cuts[n] : from_other_end(cuts[n]);
    }
  }

  /// The same of edges that leave all solids together.
  void leave_all(std::span<const PartedEdge> edges, std::span<const std::size_t> which,
                 std::span<std::uint16_t> out) const {
    std::vector<PartedEdge> some;
    for (const std::size_t e : which) some.push_back(edges[e]);
    std::vector<std::uint16_t> cuts(some.size());
    Domain::part(some, cuts);
    for (std::size_t n = 0; n < which.size(); ++n) out[which[n]] = cuts[n];
  }

  static std::uint16_t from_other_end(std::uint16_t cut) {
    return static_cast<std::uint16_t>(std::min(steps - cut, steps - 1));
  }

  /// `signs_of` gives those of a solid, for all points, which are in the box, if there is one.
  template <class SignsOf>
  void unite(std::span<Sign> out, const std::optional<LatticeBox>& box,
             const SignsOf& signs_of) const {
    std::ranges::fill(out, Sign::minus);
    std::vector<Sign> signs(out.size());
    for (const auto& solid : solids_) {
      if (box && solid->extent(*box) == Extent::outside) continue;
      signs_of(*solid, signs);
      std::ranges::transform(out, signs, out.begin(), united);
    }
  }

  template <class SignsOf>
  void choose(std::span<Material> out, const std::optional<LatticeBox>& box,
              const SignsOf& signs_of) const {
    std::ranges::fill(out, 0);
    std::vector<Sign> signs(out.size());
    for (const Material material : strongest_) {
      const Domain& solid = this->solid(material);
      if (box && solid.extent(*box) == Extent::outside) continue;
      signs_of(solid, signs);
      for (std::size_t i = 0; i < out.size(); ++i)
        if (out[i] == 0 && signs[i] != Sign::minus) out[i] = material;
    }
  }

  std::vector<Material> strongest_;        ///< first
  std::vector<std::size_t> strength_;      ///< of each material; 0 outside
  std::vector<std::string> names_;         ///< of the materials
  double side_;
  PlacedLattice around_;
  std::vector<std::shared_ptr<const PlacedDomain>> solids_;  ///< of the materials
  std::vector<std::int32_t> labels_;
  std::vector<BorderBox> border_;
};

}  // namespace

std::unique_ptr<PlacedDomain> materials_domain(const std::vector<NamedSolid>& solids,
                                               const MaterialsLattice& lattice,
                                               const std::vector<std::string>& priority) {
  if (solids.empty()) throw Error(ErrorCode::bad_option, "there is no solid to be meshed");
  return std::make_unique<MaterialsDomain>(solids, strongest_first(names_of(solids), priority),
                                           around(solids), lattice);
}

}  // namespace certet
