#include "combined_domain.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "united.hpp"

namespace certet {
namespace {

Sign opposite(Sign sign) {
  if (sign == Sign::on_surface) return sign;
  return sign == Sign::plus ? Sign::minus : Sign::plus;
}

Extent opposite(Extent extent) {
  if (extent == Extent::mixed) return extent;
  return extent == Extent::inside ? Extent::outside : Extent::inside;
}

/// What has no labels of its own.
class OneMaterial : public PlacedDomain {
 public:
  explicit OneMaterial(DomainPart domain) : domain_(std::move(domain)) {}

  [[nodiscard]] const Frame& frame() const override { return domain_->frame(); }
  [[nodiscard]] const Lattice& lattice() const override { return domain_->lattice(); }
  [[nodiscard]] double longest_side() const override { return domain_->longest_side(); }
  [[nodiscard]] std::uint64_t bytes() const override { return domain_->bytes(); }
  [[nodiscard]] std::span<const BorderBox> border() const override { return domain_->border(); }
  [[nodiscard]] bool is_sampled() const override { return domain_->is_sampled(); }
  [[nodiscard]] std::size_t batch() const override { return domain_->batch(); }
  void row(Coord3 first, std::span<Sign> out) const override { domain_->row(first, out); }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    domain_->at(positions, out);
  }
  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    return domain_->extent(box);
  }

 private:
  DomainPart domain_;
};

class OppositeDomain final : public OneMaterial {
 public:
  using OneMaterial::OneMaterial;

  void row(Coord3 first, std::span<Sign> out) const override {
    OneMaterial::row(first, out);
    for (Sign& sign : out) sign = opposite(sign);
  }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    OneMaterial::at(positions, out);
    for (Sign& sign : out) sign = opposite(sign);
  }
  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    return opposite(OneMaterial::extent(box));
  }
};

/// What is in both.
struct Both {
  static Sign sign(Sign a, Sign b) { return std::min(a, b); }
  static Extent extent(Extent a, Extent b) {
    if (a == Extent::outside || b == Extent::outside) return Extent::outside;
    return a == b ? a : Extent::mixed;
  }
};

/// What is in either.
struct Either {
  static Sign sign(Sign a, Sign b) { return united(a, b); }
  static Extent extent(Extent a, Extent b) {
    if (a == Extent::inside || b == Extent::inside) return Extent::inside;
    return a == b ? a : Extent::mixed;
  }
};

template <class Rule>
class CombinedDomain : public PlacedDomain {
 public:
  CombinedDomain(DomainPart a, DomainPart b, const PlacedLattice& around, double side)
      : a_(std::move(a)), b_(std::move(b)), around_(around), side_(side) {
    for (const DomainPart& part : {a_, b_})
      border_.insert(border_.end(), part->border().begin(), part->border().end());
  }

  [[nodiscard]] const Frame& frame() const override { return around_.frame; }
  [[nodiscard]] const Lattice& lattice() const override { return around_.lattice; }
  [[nodiscard]] double longest_side() const override { return side_; }
  [[nodiscard]] std::uint64_t bytes() const override { return a_->bytes() + b_->bytes(); }
  [[nodiscard]] std::span<const BorderBox> border() const override { return border_; }
  [[nodiscard]] bool is_sampled() const override { return a_->is_sampled() || b_->is_sampled(); }
  [[nodiscard]] std::size_t batch() const override { return std::max(a_->batch(), b_->batch()); }

  void row(Coord3 first, std::span<Sign> out) const override {
    std::vector<Sign> others(out.size());
    a_->row(first, out);
    b_->row(first, others);
    std::ranges::transform(out, others, out.begin(), Rule::sign);
  }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    std::vector<Sign> others(out.size());
    a_->at(positions, out);
    b_->at(positions, others);
    std::ranges::transform(out, others, out.begin(), Rule::sign);
  }
  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    return Rule::extent(a_->extent(box), b_->extent(box));
  }

 protected:
  DomainPart a_, b_;

 private:
  PlacedLattice around_;
  double side_;
  std::vector<BorderBox> border_;
};

/// What is in both, where the first has labels.
class LabelledPart final : public CombinedDomain<Both> {
 public:
  using CombinedDomain::CombinedDomain;

  [[nodiscard]] bool even_points_tell_pieces() const override {
    return a_->even_points_tell_pieces();
  }
  [[nodiscard]] std::span<const std::int32_t> labels() const override { return a_->labels(); }
  [[nodiscard]] LabelNames names() const override { return a_->names(); }

  void row_materials(Coord3 first, std::span<Material> out) const override {
    std::vector<Sign> signs(out.size());
    a_->row_materials(first, out);
    b_->row(first, signs);
    leave_out(signs, out);
  }
  void materials_at(std::span<const Coord3> positions, std::span<Material> out) const override {
    std::vector<Sign> signs(out.size());
    a_->materials_at(positions, out);
    b_->at(positions, signs);
    leave_out(signs, out);
  }
  [[nodiscard]] std::optional<Material> material_of(const LatticeBox& box) const override {
    switch (b_->extent(box)) {
      case Extent::outside: return 0;
      case Extent::inside: return a_->material_of(box);
      case Extent::mixed: break;
    }
    const std::optional<Material> found = a_->material_of(box);
    return found == 0 ? found : std::nullopt;
  }

  /// Two materials part as in the first; from a material to the outside an edge is cut where it
  /// leaves one of both, or the nearer such place where it leaves both.
  void part(std::span<const PartedEdge> edges, std::span<std::uint16_t> out) const override {
    std::vector<Coord3> last;
    for (const PartedEdge& edge : edges) last.push_back(steps * edge.last);
    std::vector<Sign> in_a(edges.size()), in_b(edges.size());
    a_->at(last, in_a);
    b_->at(last, in_b);
    std::ranges::fill(out, static_cast<std::uint16_t>(steps - 1));
    const auto cut = [&](const Domain& domain, const auto& is_cut_by) {
      std::vector<PartedEdge> some;
      std::vector<std::size_t> which;
      for (std::size_t e = 0; e < edges.size(); ++e)
        if (is_cut_by(e)) which.push_back(e), some.push_back(edges[e]);
      std::vector<std::uint16_t> cuts(some.size());
      domain.part(some, cuts);
      for (std::size_t n = 0; n < which.size(); ++n)
        out[which[n]] = std::min(out[which[n]], cuts[n]);
    };
    cut(*a_, [&](std::size_t e) { return edges[e].of_last != 0 || in_a[e] == Sign::minus; });
    cut(*b_, [&](std::size_t e) { return edges[e].of_last == 0 && in_b[e] == Sign::minus; });
  }

 private:
  static void leave_out(std::span<const Sign> signs, std::span<Material> out) {
    for (std::size_t i = 0; i < out.size(); ++i)
      if (signs[i] == Sign::minus) out[i] = 0;
  }
};

}  // namespace

DomainPart both(const DomainPart& a, const DomainPart& b, const PlacedLattice& around,
                double side) {
  if (!a->labels().empty()) return std::make_shared<LabelledPart>(a, b, around, side);
  return std::make_shared<CombinedDomain<Both>>(a, b, around, side);
}

DomainPart either(const DomainPart& a, const DomainPart& b, const PlacedLattice& around,
                  double side) {
  return std::make_shared<CombinedDomain<Either>>(a, b, around, side);
}

DomainPart as_one(const DomainPart& a) {
  return a->labels().size() > 1 ? std::make_shared<OneMaterial>(a) : a;
}

DomainPart opposite(const DomainPart& a) { return std::make_shared<OppositeDomain>(a); }

}  // namespace certet
