#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "certet/error.hpp"
#include "certet/surface.hpp"
#include "edges.hpp"
#include "exact.hpp"
#include "inside.hpp"
#include "surface_blocks.hpp"
#include "surface_box.hpp"
#include "triangle_columns.hpp"

namespace certet {
namespace {

using exact::Nudge;

/// Frame and lattice.
struct Place {
  Frame frame;
  Lattice lattice;
  double longest_side = 0;

  /// Of others, where the surface has room.
  Place(const SurfaceBox& box, const PlacedLattice& around)
      : frame(around.frame), lattice(around.lattice), longest_side(box.longest()) {
    constexpr double reach = std::int32_t{anchor_limit};
    for (std::size_t a = 0; a < 3; ++a)
      for (const double end : {box.low[a], box.high[a]})
        if (!(std::fabs(end - frame.origin[a]) < reach * (frame.size / 2)))
          throw Error(ErrorCode::too_large, "a surface reaches beyond the lattice it is put on");
  }

  Place(const SurfaceBox& box, const SurfaceLattice& choice) : longest_side(box.longest()) {
    frame.size = choice.size == 0 ? box.longest() / 64 : choice.size;
    if (choice.size == 0 && frame.size == 0) frame.size = 1;  // one point: nothing is inside
    checked_size(frame.size);
    checked_margin(choice.margin);
    for (std::size_t a = 0; a < 3; ++a) {
      frame.origin[a] = box.low[a] + box.side(a) / 2;
      // Even, so that lattice point (0,0,0) is in the middle.
      lattice.cells[a] = checked_cells(
          2 * (std::ceil(box.side(a) / (2 * frame.size)) + choice.margin));
    }
    lattice.origin = {-lattice.cells[0], -lattice.cells[1], -lattice.cells[2]};
  }

  /// A world point, rounded to steps.
  [[nodiscard]] Coord3 position(const Point3& point) const {
    const double unit = frame.size / (2.0 * steps);
    const auto rounded = [&](std::size_t a) {
      return static_cast<std::int32_t>(std::lround((point[a] - frame.origin[a]) / unit));
    };
    return {rounded(0), rounded(1), rounded(2)};
  }
};

/// Points of triangles only: others may be anywhere.
std::vector<Coord3> positions(const TriangleSurface& surface, const Place& place) {
  std::vector<Coord3> result(surface.points.size(), Coord3{0, 0, 0});
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t point : triangle)
      result[point] = place.position(surface.points[point]);
  return result;
}

class SurfaceDomain final : public PlacedDomain {
 public:
  SurfaceDomain(const TriangleSurface& surface, const Place& place, Rule rule)
      : place_(place),
        inside_(surface, positions(surface, place), rule),
        columns_(positions(surface, place), surface.triangles),
        blocks_(place.lattice) {
    for (std::uint32_t t = 0; t < columns_.size(); ++t) blocks_.add(columns_.corners(t));
  }

  [[nodiscard]] const Frame& frame() const override { return place_.frame; }
  [[nodiscard]] const Lattice& lattice() const override { return place_.lattice; }
  [[nodiscard]] double longest_side() const override { return place_.longest_side; }
  [[nodiscard]] std::uint64_t bytes() const override {
    return columns_.bytes() + blocks_.bytes() + inside_.bytes();
  }

  /// Of a surface with holes the solid has more than these around it.
  [[nodiscard]] std::vector<TriangleCorners> triangles() const override {
    std::vector<TriangleCorners> all;
    if (inside_.rule() == Rule::half) return all;
    for (std::uint32_t t = 0; t < columns_.size(); ++t) all.push_back(columns_.corners(t));
    return all;
  }

  void row(Coord3 first, std::span<Sign> out) const override {
    RowOfSigns(*this, first, out).find();
  }

  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = sign(positions[i]);
  }

  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    if (blocks_.any(box)) return Extent::mixed;
    constexpr std::int32_t halves = steps / 2;
    const Coord3 middle = halves * (box.low + box.high);
    return inside_.over({steps * box.low, steps * box.high}, middle,
                        columns_.crossings(middle, Nudge::forward));
  }

 private:
  [[nodiscard]] Sign sign(Coord3 p) const {
    int sum = 0;
    bool touched = false;
    columns_.for_each_ahead(p, [&](const exact::Corners& t) {
      const exact::Normal n = exact::normal(t);
      touched = touched || exact::touches(t, n, p);
      const int direction = exact::passing(t, p, Nudge::forward);
      if (direction != 0 && exact::ahead(t, n, direction, p, Nudge::forward)) sum += direction;
    });
    return sign_given(p, sum, touched);
  }

  /// Given the crossings of the point moved forward, and whether it is on a triangle.
  [[nodiscard]] Sign sign_given(Coord3 p, int sum, bool touched) const {
    const Sign forward = inside_.at(sum, p, Nudge::forward);
    if (!touched) return forward;
    const auto inside_backward = [&] {
      return inside_.at(columns_.crossings(p, Nudge::backward), p, Nudge::backward) == Sign::plus;
    };
    return forward == Sign::plus && inside_backward() ? Sign::plus : Sign::on_surface;
  }

  /// Lattice points first, first + (2,0,0), … with each triangle looked at once.
  class RowOfSigns {
   public:
    RowOfSigns(const SurfaceDomain& domain, Coord3 first, std::span<Sign> out)
        : domain_(domain), first_(steps * first), out_(out), changes_(out.size() + 1, 0),
          touched_(out.size(), false) {}

    void find() {
      domain_.columns_.for_each_ahead(first_, [&](const exact::Corners& t) { add(t); });
      int sum = 0;
      for (std::size_t i = out_.size(); i-- > 0;) {
        sum += changes_[i + 1];
        out_[i] = domain_.sign_given(point(i), sum, touched_[i]);
      }
    }

   private:
    static constexpr std::int64_t stride = 2 * std::int64_t{steps};

    [[nodiscard]] Coord3 point(std::size_t i) const {
      return {static_cast<std::int32_t>(first_.x + stride * static_cast<std::int64_t>(i)),
              first_.y, first_.z};
    }
    /// The number of points less than a distance from the first.
    [[nodiscard]] std::size_t points_before(std::int64_t distance) const {
      const std::int64_t count = distance <= 0 ? 0 : (distance - 1) / stride + 1;
      return std::min(static_cast<std::size_t>(count), out_.size());
    }

    void add(const exact::Corners& t) {
      const exact::Normal n = exact::normal(t);
      const exact::Wide height = exact::height(t, n, first_);
      if (n.x == 0) {
        if (height == 0) touch_along(t, n);
        return;
      }
      // The row meets the plane this far from its first point, which is a whole
      // number of steps, or that and less than one more.
      exact::Wide distance = -height / n.x;
      const bool whole = distance * n.x == -height;
      if (!whole && (height > 0) == (n.x > 0)) --distance;
      const auto bounded = static_cast<std::int64_t>(
          std::clamp<exact::Wide>(distance, -1, exact::Wide{stride} * out_.size()));
      add_passing(t, n, points_before(whole ? bounded : bounded + 1));
    }

    /// The triangle's plane is ahead of the first `before` points, and it may be
    /// at the next.
    void add_passing(const exact::Corners& t, const exact::Normal& n, std::size_t before) {
      if (before < out_.size() && exact::touches(t, n, point(before))) touched_[before] = true;
      const int direction = exact::passing(t, first_, Nudge::forward);
      if (direction == 0) return;
      if (before < out_.size() && exact::ahead(t, n, direction, point(before), Nudge::forward))
        ++before;
      changes_[before] += direction;
    }

    /// The row runs in the triangle's plane.
    void touch_along(const exact::Corners& t, const exact::Normal& n) {
      const auto [low, high] = std::minmax({t[0].x, t[1].x, t[2].x});
      const std::size_t end = points_before(exact::gap(first_.x, high) + 1);
      for (std::size_t i = points_before(exact::gap(first_.x, low)); i < end; ++i)
        if (exact::touches(t, n, point(i))) touched_[i] = true;
    }

    const SurfaceDomain& domain_;
    Coord3 first_;
    std::span<Sign> out_;
    std::vector<int> changes_;  ///< [i]: of the triangles ahead of i points
    std::vector<bool> touched_;
  };

  Place place_;
  Inside inside_;
  TriangleColumns columns_;
  SurfaceBlocks blocks_;
};

std::unique_ptr<PlacedDomain> domain_of(const TriangleSurface& surface,
                                        const SurfaceLattice& lattice, Rule rule) {
  SurfaceLattice chosen = lattice;
  if (chosen.size == 0) chosen.size = default_size(surface, measure(surface)).size;
  return std::make_unique<SurfaceDomain>(surface, Place(SurfaceBox(surface), chosen), rule);
}

Solid solid_of(std::shared_ptr<const TriangleSurface> surface, Rule rule) {
  const SurfaceBox box(*surface);
  return {{box.low, box.high},
          [surface = std::move(surface), rule](const PlacedLattice& around) {
            return std::make_shared<SurfaceDomain>(*surface, Place(SurfaceBox(*surface), around), rule);
          }};
}

}  // namespace

std::unique_ptr<PlacedDomain> surface_domain(const TriangleSurface& surface,
                                             const SurfaceLattice& lattice) {
  refuse_malformed(surface);
  return domain_of(surface, lattice, closed_rule(surface));
}

std::unique_ptr<PlacedDomain> open_surface_domain(const TriangleSurface& surface,
                                                  const SurfaceLattice& lattice) {
  refuse_malformed(surface);
  return domain_of(surface, lattice, open_rule(surface));
}

Solid surface_solid(std::shared_ptr<const TriangleSurface> surface) {
  refuse_malformed(*surface);
  const Rule rule = closed_rule(*surface);
  return solid_of(std::move(surface), rule);
}

Solid open_surface_solid(std::shared_ptr<const TriangleSurface> surface) {
  refuse_malformed(*surface);
  const Rule rule = open_rule(*surface);
  return solid_of(std::move(surface), rule);
}

}  // namespace certet
