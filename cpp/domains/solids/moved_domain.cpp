#include "certet/moved_domain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace certet {
namespace {

using Position = std::array<std::int64_t, 3>;

Position wide(Coord3 p) { return {p.x, p.y, p.z}; }
Coord3 narrow(const Position& p) {
  return {static_cast<std::int32_t>(p[0]), static_cast<std::int32_t>(p[1]),
          static_cast<std::int32_t>(p[2])};
}

/// From positions on one lattice to those on another, in steps.
class Way {
 public:
  Way(const Frame& from, const Frame& to) {
    const double ratio = from.size / to.size;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t b = 0; b < 3; ++b) turn_[a][b] += to.axes[r][a] * from.axes[r][b];
        shift_[a] += 2 * steps / to.size * to.axes[r][a] * (from.origin[r] - to.origin[r]);
      }
    if (from.axes == to.axes) turn_ = Frame{}.axes;
    for (auto& row : turn_)
      for (double& one : row) one *= ratio;
    exact_ = meets_points();
  }

  /// Whether points of the lattices, even and odd, are points of the other one, and axes go
  /// along each other.
  [[nodiscard]] bool exact() const { return exact_; }
  /// Along x in the other lattice, 1 or -1 times; 0 if neither.
  [[nodiscard]] int along_x() const {
    return exact_ ? static_cast<int>(turn_[0][0]) : 0;
  }

  [[nodiscard]] Position operator()(Coord3 p) const {
    Position q{};
    for (std::size_t a = 0; a < 3; ++a) q[a] = std::llround(place(a, p));
    return q;
  }

  /// Before rounding.
  [[nodiscard]] double place(std::size_t a, Coord3 p) const {
    return turn_[a][0] * p.x + turn_[a][1] * p.y + turn_[a][2] * p.z + shift_[a];
  }

  /// Of a lattice point, where the way is exact.
  [[nodiscard]] Coord3 point(Coord3 p) const {
    Position q{};
    for (std::size_t a = 0; a < 3; ++a)
      q[a] = std::llround(turn_[a][0] * p.x + turn_[a][1] * p.y + turn_[a][2] * p.z +
                          shift_[a] / steps);
    return narrow(q);
  }

 private:
  /// Shifts by whole cells are so but for rounding, which is taken off.
  bool meets_points() {
    for (const auto& row : turn_)
      for (const double one : row)
        if (one != 0 && std::fabs(one) != 1) return false;
    Point3 whole{};
    for (std::size_t a = 0; a < 3; ++a) {
      whole[a] = std::round(shift_[a] / (2 * steps)) * (2 * steps);
      if (!(std::fabs(whole[a] - shift_[a]) < 0.125)) return false;
    }
    shift_ = whole;
    return true;
  }

  std::array<std::array<double, 3>, 3> turn_{};
  Point3 shift_{};
  bool exact_ = false;
};

class MovedDomain final : public PlacedDomain {
 public:
  MovedDomain(std::shared_ptr<const PlacedDomain> domain, const PlacedLattice& around,
              const Frame& there)
      : domain_(std::move(domain)), around_(around), way_(there, domain_->frame()) {
    for (const BorderBox& box : domain_->border())
      border_.push_back(box.seen_from(there, domain_->frame()));
    const auto& [origin, cells] = domain_->lattice();
    low_ = wide(origin);
    for (std::size_t a = 0; a < 3; ++a) high_[a] = low_[a] + 2 * cells[a];
  }

  [[nodiscard]] const Frame& frame() const override { return around_.frame; }
  [[nodiscard]] const Lattice& lattice() const override { return around_.lattice; }
  [[nodiscard]] double longest_side() const override { return domain_->longest_side(); }
  [[nodiscard]] std::uint64_t bytes() const override { return domain_->bytes(); }
  [[nodiscard]] std::span<const BorderBox> border() const override { return border_; }
  [[nodiscard]] bool is_sampled() const override { return domain_->is_sampled(); }
  [[nodiscard]] std::size_t batch() const override { return domain_->batch(); }
  [[nodiscard]] std::span<const std::int32_t> labels() const override { return domain_->labels(); }
  [[nodiscard]] LabelNames names() const override { return domain_->names(); }
  [[nodiscard]] bool even_points_tell_pieces() const override {
    return way_.exact() && domain_->even_points_tell_pieces();
  }

  void row(Coord3 first, std::span<Sign> out) const override {
    answer_row(first, out, Sign::minus,
               [this](Coord3 from, std::span<Sign> signs) { domain_->row(from, signs); },
               [this](std::span<const Coord3> some, std::span<Sign> signs) {
                 domain_->at(some, signs);
               });
  }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    answer(positions, out, Sign::minus,
           [this](std::span<const Coord3> some, std::span<Sign> signs) {
             domain_->at(some, signs);
           });
  }
  void row_materials(Coord3 first, std::span<Material> out) const override {
    answer_row(first, out, Material{0},
               [this](Coord3 from, std::span<Material> materials) {
                 domain_->row_materials(from, materials);
               },
               [this](std::span<const Coord3> some, std::span<Material> materials) {
                 domain_->materials_at(some, materials);
               });
  }
  void materials_at(std::span<const Coord3> positions, std::span<Material> out) const override {
    answer(positions, out, Material{0},
           [this](std::span<const Coord3> some, std::span<Material> materials) {
             domain_->materials_at(some, materials);
           });
  }

  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    const std::optional<Reach> reach = reach_of(box);
    if (!reach) return Extent::outside;
    const Extent found = domain_->extent(reach->box);
    return found == Extent::inside && !reach->whole ? Extent::mixed : found;
  }
  [[nodiscard]] std::optional<Material> material_of(const LatticeBox& box) const override {
    const std::optional<Reach> reach = reach_of(box);
    if (!reach) return 0;
    const std::optional<Material> found = domain_->material_of(reach->box);
    return reach->whole || found == 0 ? found : std::nullopt;
  }

  void part(std::span<const PartedEdge> edges, std::span<std::uint16_t> out) const override {
    if (!way_.exact()) return Domain::part(edges, out);
    std::vector<PartedEdge> moved(edges.begin(), edges.end());
    for (PartedEdge& edge : moved) {
      edge.first = way_.point(edge.first);
      edge.last = way_.point(edge.last);
    }
    domain_->part(moved, out);
  }

 private:
  /// A box on the domain's lattice.
  struct Reach {
    LatticeBox box;
    bool whole = true;  ///< nothing of it is beyond that lattice
  };

  [[nodiscard]] bool holds(const Position& q) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (q[a] < steps * low_[a] || q[a] > steps * high_[a]) return false;
    return true;
  }

  /// Around all that positions of the box become; nothing if that is beyond the lattice.
  [[nodiscard]] std::optional<Reach> reach_of(const LatticeBox& box) const {
    Reach reach;
    Position low{}, high{};
    for (std::size_t a = 0; a < 3; ++a) {
      double least = INFINITY, most = -INFINITY;
      for (int corner = 0; corner < 8; ++corner) {
        const double at = way_.place(a, steps * Coord3{corner & 1 ? box.high.x : box.low.x,
                                                       corner & 2 ? box.high.y : box.low.y,
                                                       corner & 4 ? box.high.z : box.low.z});
        least = std::min(least, at);
        most = std::max(most, at);
      }
      const double slack = way_.exact() ? 0 : 2;  // positions are rounded
      low[a] = static_cast<std::int64_t>(std::floor((least - slack) / steps));
      high[a] = static_cast<std::int64_t>(std::ceil((most + slack) / steps));
      if (high[a] < low_[a] || low[a] > high_[a]) return std::nullopt;
      reach.whole = reach.whole && low[a] >= low_[a] && high[a] <= high_[a];
      low[a] = std::max(low[a], low_[a]);
      high[a] = std::min(high[a], high_[a]);
    }
    reach.box = {narrow(low), narrow(high)};
    return reach;
  }

  /// `ask` is given positions of the domain.
  template <class Answer, class Ask>
  void answer(std::span<const Coord3> positions, std::span<Answer> out, Answer beyond,
              const Ask& ask) const {
    std::vector<Coord3> some;
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = beyond;
      const Position q = way_(positions[i]);
      if (!holds(q)) continue;
      some.push_back(narrow(q));
      which.push_back(i);
    }
    std::vector<Answer> answers(some.size());
    ask(some, answers);
    for (std::size_t n = 0; n < which.size(); ++n) out[which[n]] = answers[n];
  }

  /// `ask_row` is given a lattice point of the domain, where its rows are rows.
  template <class Answer, class AskRow, class Ask>
  void answer_row(Coord3 first, std::span<Answer> out, Answer beyond, const AskRow& ask_row,
                  const Ask& ask) const {
    const auto count = static_cast<std::int64_t>(out.size());
    if (count == 0) return;
    const auto point = [first](std::int64_t i) {
      return first + Coord3{2 * static_cast<std::int32_t>(i), 0, 0};
    };
    const int along = way_.along_x();
    if (along == 0) {
      std::vector<Coord3> positions;
      for (std::int64_t i = 0; i < count; ++i) positions.push_back(steps * point(i));
      return answer(positions, out, beyond, ask);
    }
    const Position from = way_(steps * point(along > 0 ? 0 : count - 1));
    std::ranges::fill(out, beyond);
    if (!holds({steps * low_[0], from[1], from[2]})) return;
    // Those of the row that are on the domain's lattice.
    const std::int64_t x = from[0] / steps;
    const std::int64_t begin = std::clamp<std::int64_t>((low_[0] - x + 1) / 2, 0, count);
    const std::int64_t end =
        std::clamp<std::int64_t>(high_[0] < x ? 0 : (high_[0] - x) / 2 + 1, begin, count);
    if (begin == end) return;
    const Position there{from[0] / steps + 2 * begin, from[1] / steps, from[2] / steps};
    ask_row(narrow(there),
            out.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin)));
    if (along < 0) std::ranges::reverse(out);
  }

  std::shared_ptr<const PlacedDomain> domain_;
  PlacedLattice around_;
  Way way_;
  Position low_{}, high_{};  ///< of the domain's lattice, in lattice units
  std::vector<BorderBox> border_;
};

}  // namespace

std::shared_ptr<const PlacedDomain> moved_domain(std::shared_ptr<const PlacedDomain> domain,
                                                 const PlacedLattice& around) {
  return moved_domain(std::move(domain), around, around.frame);
}

std::shared_ptr<const PlacedDomain> moved_domain(std::shared_ptr<const PlacedDomain> domain,
                                                 const PlacedLattice& around, const Frame& there) {
  return std::make_shared<MovedDomain>(std::move(domain), around, there);
}

}  // namespace certet
