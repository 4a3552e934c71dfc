#include "sides.hpp"

#include <cmath>

namespace certet::distance {

std::optional<Material> Sides::of(const LatticeBox& box) const {
  if (materials) return domain.material_of(box);
  switch (domain.extent(box)) {
    case Extent::inside: return 1;
    case Extent::outside: return 0;
    case Extent::mixed: break;
  }
  return std::nullopt;
}

Question::Question(const Sides& sides) : sides_(sides) {
  const auto& [origin, cells] = sides.domain.lattice();
  low_ = {double(origin.x), double(origin.y), double(origin.z)};
  for (std::size_t a = 0; a < 3; ++a) high_[a] = low_[a] + 2 * cells[a];
}

void Question::clear() {
  positions_.clear();
  beyond_.clear();
}

void Question::add(const Point3& position) {
  bool beyond = false;
  for (std::size_t a = 0; a < 3; ++a)
    beyond = beyond || !(position[a] >= low_[a] && position[a] <= high_[a]);
  const Point3& at = beyond ? low_ : position;
  const auto step = [&](std::size_t a) { return static_cast<std::int32_t>(std::lround(at[a] * steps)); };
  positions_.push_back({step(0), step(1), step(2)});
  beyond_.push_back(beyond);
}

void Question::ask() {
  answers_.resize(size());
  if (sides_.materials) {
    sides_.domain.materials_at(positions_, answers_);
  } else {
    signs_.resize(size());
    sides_.domain.at(positions_, signs_);
    for (std::size_t i = 0; i < size(); ++i) answers_[i] = signs_[i] == Sign::minus ? 0 : 1;
  }
  for (std::size_t i = 0; i < size(); ++i)
    if (beyond_[i]) answers_[i] = 0;
}

}  // namespace certet::distance
