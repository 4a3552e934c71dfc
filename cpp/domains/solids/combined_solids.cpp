#include "certet/combined_solids.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "certet/error.hpp"
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

/// What is in the first alone.
struct Without {
  static Sign sign(Sign a, Sign b) { return Both::sign(a, opposite(b)); }
  static Extent extent(Extent a, Extent b) { return Both::extent(a, opposite(b)); }
};

template <class Rule>
class CombinedDomain final : public PlacedDomain {
 public:
  using Part = std::shared_ptr<const PlacedDomain>;

  CombinedDomain(Part a, Part b, const Bounds& bounds)
      : a_(std::move(a)), b_(std::move(b)), side_(certet::longest_side(bounds)) {
    for (const Part& part : {a_, b_})
      border_.insert(border_.end(), part->border().begin(), part->border().end());
  }

  [[nodiscard]] const Frame& frame() const override { return a_->frame(); }
  [[nodiscard]] const Lattice& lattice() const override { return a_->lattice(); }
  [[nodiscard]] double longest_side() const override { return side_; }
  [[nodiscard]] std::uint64_t bytes() const override { return a_->bytes() + b_->bytes(); }
  [[nodiscard]] std::span<const BorderBox> border() const override { return border_; }

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

 private:
  Part a_, b_;
  double side_;
  std::vector<BorderBox> border_;
};

template <class Rule>
Solid combined(const Solid& a, const Solid& b, const Bounds& bounds) {
  return {bounds, [a = a.on, b = b.on, bounds](const PlacedLattice& lattice) {
            return std::make_shared<CombinedDomain<Rule>>(a(lattice), b(lattice), bounds);
          }};
}

Bounds common(const Bounds& one, const Bounds& other) {
  Bounds both = one;
  for (std::size_t a = 0; a < 3; ++a) {
    both.low[a] = std::max(both.low[a], other.low[a]);
    both.high[a] = std::min(both.high[a], other.high[a]);
    if (!(both.low[a] < both.high[a]))
      throw Error(ErrorCode::bad_option, "two solids have no place in common");
  }
  return both;
}

}  // namespace

Solid operator&(const Solid& a, const Solid& b) {
  return combined<Both>(a, b, common(a.bounds, b.bounds));
}

Solid operator|(const Solid& a, const Solid& b) {
  return combined<Either>(a, b, around(a.bounds, b.bounds));
}

Solid operator-(const Solid& a, const Solid& b) {
  return combined<Without>(a, b, a.bounds);
}

}  // namespace certet
