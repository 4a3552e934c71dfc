#include "crossing.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace certet::quadratic {
namespace {

enum class Side { within, upon, beyond };

/// The material that a label stands for; labels are in no order.
Material material_of(const Domain& domain, std::int32_t label) {
  const std::span<const std::int32_t> labels = domain.labels();
  const auto found = std::ranges::find(labels, label);
  return labels.empty() ? 1 : static_cast<Material>(found - labels.begin()) + 1;
}

/// a / b, rounded to the nearest, halves away from 0; b > 0.
constexpr std::int64_t rounded(std::int64_t a, std::int64_t b) {
  return a < 0 ? -((2 * -a + b) / (2 * b)) : (2 * a + b) / (2 * b);
}

/// The positions along the normal of an edge, and how far the search has come.
class Path {
 public:
  Path(const SurfaceEdge& edge, const Domain& domain)
      : edge_(&edge), material_(material_of(domain, edge.label)) {
    for (const std::int64_t n : edge.normal) greatest_ = std::max(greatest_, std::abs(n));
    end_ = greatest_ == 0 ? 0 : std::max(edge.length / 4, 1);
  }

  [[nodiscard]] const SurfaceEdge& edge() const { return *edge_; }
  [[nodiscard]] Material material() const { return material_; }  ///< within
  [[nodiscard]] bool is_open() const { return !done_; }
  /// Where the domain is to be asked next.
  [[nodiscard]] Coord3 position() const { return at(next_) + edge_->inward; }

  void take(Side side);
  [[nodiscard]] Crossing result() const;

 private:
  /// So many steps outward from the middle, which is rounded down.
  [[nodiscard]] Coord3 at(std::int64_t steps_out) const {
    std::array<std::int32_t, 3> place;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::int64_t aside =
          greatest_ == 0 ? 0 : rounded(steps_out * edge_->normal[a], greatest_);
      place[a] = static_cast<std::int32_t>((edge_->middle2[a] >> 1) + aside);
    }
    return {place[0], place[1], place[2]};
  }
  void start(Side side);
  void go_farther();
  void halve();
  void finish(Found found) {
    found_ = found;
    done_ = true;
  }

  const SurfaceEdge* edge_;
  Material material_;
  std::int64_t greatest_ = 0;  ///< extent of the normal
  std::int64_t end_;           ///< the search goes no farther
  std::int64_t next_ = 0;      ///< where it looks
  std::int64_t near_ = 0, far_ = 0;  ///< on the middle's side; on the other, or 0
  std::int64_t direction_ = 0;
  Side middle_ = Side::upon;
  Found found_ = Found::far;
  bool done_ = false;
};

void Path::take(Side side) {
  if (direction_ == 0) return start(side);
  if (side == Side::upon) return far_ = next_, finish(Found::moved);
  (side == middle_ ? near_ : far_) = next_;
  far_ == 0 ? go_farther() : halve();
}

void Path::start(Side side) {
  if (side == Side::upon) return finish(Found::on_surface);
  if (end_ == 0) return finish(Found::far);
  middle_ = side;
  direction_ = side == Side::within ? 1 : -1;
  next_ = direction_ * std::max<std::int64_t>(end_ / 8, 1);
}

void Path::go_farther() {
  if (std::abs(next_) >= end_) return finish(Found::far);
  next_ = direction_ * std::min(2 * std::abs(next_), end_);
}

void Path::halve() {
  if (std::abs(far_ - near_) == 1) return finish(Found::moved);
  next_ = near_ + (far_ - near_) / 2;
}

Crossing Path::result() const {
  if (found_ != Found::moved) return {found_, {}};
  const Coord3 place = at(far_);
  const auto bend = [this](std::int32_t coordinate, std::size_t axis) {
    return static_cast<std::int32_t>(2 * std::int64_t{coordinate} - edge_->middle2[axis]);
  };
  return {found_, {bend(place.x, 0), bend(place.y, 1), bend(place.z, 2)}};
}

/// Asks for the sides of all of some paths at once.
class Question {
 public:
  explicit Question(const Domain& domain) : domain_(domain) {}

  void ask(std::span<Path* const> paths) {
    positions_.clear();
    for (const Path* path : paths) positions_.push_back(path->position());
    signs_.resize(paths.size());
    materials_.resize(paths.size());
    const auto is_outer = [](const Path* path) { return path->edge().outer; };
    if (std::ranges::any_of(paths, is_outer)) domain_.at(positions_, signs_);
    if (!std::ranges::all_of(paths, is_outer)) domain_.materials_at(positions_, materials_);
    for (std::size_t i = 0; i < paths.size(); ++i) paths[i]->take(side(*paths[i], i));
  }

 private:
  [[nodiscard]] Side side(const Path& path, std::size_t i) const {
    if (!path.edge().outer)
      return materials_[i] == path.material() ? Side::within : Side::beyond;
    switch (signs_[i]) {
      case Sign::plus: return Side::within;
      case Sign::on_surface: return Side::upon;
      case Sign::minus: break;
    }
    return Side::beyond;
  }

  const Domain& domain_;
  std::vector<Coord3> positions_;
  std::vector<Sign> signs_;
  std::vector<Material> materials_;
};

}  // namespace

void find_crossings(std::span<const SurfaceEdge> edges, const Domain& domain,
                    std::span<Crossing> out) {
  std::vector<Path> paths;
  for (const SurfaceEdge& edge : edges) paths.emplace_back(edge, domain);
  std::vector<Path*> open;
  for (Path& path : paths) open.push_back(&path);
  Question question(domain);
  while (!open.empty()) {
    question.ask(open);
    std::erase_if(open, [](const Path* path) { return !path->is_open(); });
  }
  std::ranges::transform(paths, out.begin(), [](const Path& path) { return path.result(); });
}

}  // namespace certet::quadratic
