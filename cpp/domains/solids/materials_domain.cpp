#include "certet/materials_domain.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "certet/error.hpp"
#include "combined_domain.hpp"
#include "common_lattice.hpp"
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

/// A solid on the lattice of all, and which materials are its own.
struct SolidPart {
  std::shared_ptr<const PlacedDomain> domain;
  std::vector<std::int32_t> labels;  ///< of its materials
  Material before = 0;  ///< the materials of weaker ones; its first is the next

  [[nodiscard]] bool has(Material material) const {
    return material > before && material - before <= static_cast<Material>(labels.size());
  }
};

/// The labels that some solids bring along, and numbers for the others.
class LabelNumbers {
 public:
  /// \throws Error `bad_input` for a label that another solid has.
  void keep(const std::vector<std::int32_t>& labels, const std::string& name) {
    for (const std::int32_t label : labels) {
      const auto [at, is_new] = owners_.emplace(label, name);
      if (!is_new)
        throw Error(ErrorCode::bad_input, "'" + at->second + "' and '" + name +
                                              "' both have label " + std::to_string(label));
    }
  }

  /// The next after the greatest; where there is none, the least positive one.
  std::int32_t next(const std::string& name) {
    std::int32_t label = 1;
    if (!owners_.empty() && owners_.rbegin()->first < std::numeric_limits<std::int32_t>::max())
      label = std::max(label, owners_.rbegin()->first + 1);
    else
      while (owners_.contains(label)) ++label;
    owners_.emplace(label, name);
    return label;
  }

 private:
  std::map<std::int32_t, std::string> owners_;  ///< the solids that have them
};

/// In the order of the solids.
std::vector<SolidPart> placed_parts(const std::vector<NamedSolid>& solids,
                                    const PlacedLattice& around) {
  std::vector<SolidPart> parts;
  LabelNumbers numbers;
  for (const NamedSolid& one : solids) {
    SolidPart& part = parts.emplace_back(SolidPart{placed_on(one.solid, around), {}, 0});
    if (one.keeps_labels) {
      const std::span<const std::int32_t> own = part.domain->labels();
      part.labels.assign(own.begin(), own.end());
      numbers.keep(part.labels, one.name);
    } else {
      part.domain = as_one(part.domain);
    }
  }
  for (std::size_t n = 0; n < parts.size(); ++n)
    if (parts[n].labels.empty()) parts[n].labels.push_back(numbers.next(solids[n].name));
  return parts;
}

LabelNames names_of_labels(const std::vector<NamedSolid>& solids,
                           const std::vector<SolidPart>& parts) {
  LabelNames names;
  for (std::size_t n = 0; n < parts.size(); ++n)
    if (solids[n].keeps_labels) names.merge(parts[n].domain->names());
    else names[parts[n].labels.front()] = solids[n].name;
  return names;
}

class MaterialsDomain final : public PlacedDomain {
 public:
  MaterialsDomain(const std::vector<NamedSolid>& solids,
                  const std::vector<std::string>& priority, const MaterialsLattice& lattice)
      : side_(certet::longest_side(around(solids))), around_(common_lattice(solids, lattice)) {
    std::vector<SolidPart> parts = placed_parts(solids, around_);
    names_ = names_of_labels(solids, parts);
    for (const Material solid : strongest_first(names_of(solids), priority))
      parts_.push_back(std::move(parts[static_cast<std::size_t>(solid - 1)]));
    for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) {
      part->before = static_cast<Material>(labels_.size());
      labels_.insert(labels_.end(), part->labels.begin(), part->labels.end());
      const std::span<const BorderBox> cut_off = part->domain->border();
      border_.insert(border_.end(), cut_off.begin(), cut_off.end());
    }
  }

  [[nodiscard]] const Frame& frame() const override { return around_.frame; }
  [[nodiscard]] const Lattice& lattice() const override { return around_.lattice; }
  [[nodiscard]] double longest_side() const override { return side_; }
  [[nodiscard]] std::uint64_t bytes() const override {
    std::uint64_t all = 0;
    for (const SolidPart& part : parts_) all += part.domain->bytes();
    return all;
  }
  [[nodiscard]] std::span<const std::int32_t> labels() const override { return labels_; }
  [[nodiscard]] std::span<const BorderBox> border() const override { return border_; }
  [[nodiscard]] bool is_sampled() const override {
    return std::ranges::any_of(parts_, [](const SolidPart& part) { return part.domain->is_sampled(); });
  }
  [[nodiscard]] std::size_t batch() const override {
    std::size_t most = 0;
    for (const SolidPart& part : parts_) most = std::max(most, part.domain->batch());
    return most;
  }
  [[nodiscard]] LabelNames names() const override { return names_; }

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
    for (const SolidPart& part : parts_) {
      const Extent one = part.domain->extent(box);
      if (one == Extent::inside) return Extent::inside;
      if (one == Extent::mixed) found = Extent::mixed;
    }
    return found;
  }

  void row_materials(Coord3 first, std::span<Material> out) const override {
    choose(out, box_of_row(first, out.size()),
           [&](const Domain& solid, std::span<Material> own) { solid.row_materials(first, own); });
  }
  void materials_at(std::span<const Coord3> positions, std::span<Material> out) const override {
    choose(out, std::nullopt,
           [&](const Domain& solid, std::span<Material> own) { solid.materials_at(positions, own); });
  }
  [[nodiscard]] std::optional<Material> material_of(const LatticeBox& box) const override {
    for (const SolidPart& part : parts_) {
      const std::optional<Material> own = part.domain->material_of(box);
      if (!own) return std::nullopt;
      if (*own != 0) return *own + part.before;
    }
    return 0;
  }

  void part(std::span<const PartedEdge> edges, std::span<std::uint16_t> out) const override {
    std::vector<std::size_t> which;
    for (const SolidPart& part : parts_) {
      collect(edges, [&](const PartedEdge& edge) { return part.has(edge.of_first); }, which);
      if (!which.empty()) leave(part, edges, which, out);
    }
    collect(edges, [](const PartedEdge& edge) { return edge.of_first == 0; }, which);
    if (!which.empty()) leave_all(edges, which, out);
  }

 private:
  template <class IsOne>
  static void collect(std::span<const PartedEdge> edges, const IsOne& is_one,
                      std::vector<std::size_t>& which) {
    which.clear();
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (is_one(edges[e])) which.push_back(e);
  }

  /// Some of the edges have their first end, the stronger one, in a solid: where they leave it or
  /// come to another of its own materials.
  static void leave(const SolidPart& part, std::span<const PartedEdge> edges,
                    std::span<const std::size_t> which, std::span<std::uint16_t> out) {
    std::vector<PartedEdge> some;
    for (const std::size_t e : which) {
      PartedEdge edge = edges[e];
      edge.of_first -= part.before;
      edge.of_last = part.has(edge.of_last) ? edge.of_last - part.before : 0;
      some.push_back(edge);
    }
    std::vector<std::uint16_t> cuts(some.size());
    part.domain->part(some, cuts);
    for (std::size_t n = 0; n < which.size(); ++n) out[which[n]] = cuts[n];
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

  /// `signs_of` gives those of a solid, for all points, which are in the box, if there is one.
  template <class SignsOf>
  void unite(std::span<Sign> out, const std::optional<LatticeBox>& box,
             const SignsOf& signs_of) const {
    std::ranges::fill(out, Sign::minus);
    std::vector<Sign> signs(out.size());
    for (const SolidPart& part : parts_) {
      if (box && part.domain->extent(*box) == Extent::outside) continue;
      signs_of(*part.domain, signs);
      std::ranges::transform(out, signs, out.begin(), united);
    }
  }

  /// The same with materials, as the solid numbers its own.
  template <class MaterialsOf>
  void choose(std::span<Material> out, const std::optional<LatticeBox>& box,
              const MaterialsOf& materials_of) const {
    std::ranges::fill(out, 0);
    std::vector<Material> own(out.size());
    for (const SolidPart& part : parts_) {
      if (box && part.domain->extent(*box) == Extent::outside) continue;
      materials_of(*part.domain, own);
      for (std::size_t i = 0; i < out.size(); ++i)
        if (out[i] == 0 && own[i] != 0) out[i] = own[i] + part.before;
    }
  }

  double side_;
  PlacedLattice around_;
  std::vector<SolidPart> parts_;  ///< the strongest first
  std::vector<std::int32_t> labels_;
  LabelNames names_;
  std::vector<BorderBox> border_;
};

}  // namespace

std::unique_ptr<PlacedDomain> materials_domain(const std::vector<NamedSolid>& solids,
                                               const MaterialsLattice& lattice,
                                               const std::vector<std::string>& priority) {
  if (solids.empty()) throw Error(ErrorCode::bad_option, "there is no solid to be meshed");
  return std::make_unique<MaterialsDomain>(solids, priority, lattice);
}

}  // namespace certet
