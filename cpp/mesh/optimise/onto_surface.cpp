#include "onto_surface.hpp"

#include <algorithm>
#include <cmath>

namespace certet::optimising {
namespace {

enum class Side { within, upon, beyond, elsewhere };

class Normal {
 public:
  Normal(Coord3 position, const Freedom& freedom, const Domain& domain)
      : position_(position), freedom_(freedom), domain_(domain) {}

  [[nodiscard]] Coord3 at(double steps_out) const {
    return moved(position_, steps_out * freedom_.along);
  }

  [[nodiscard]] Side side(double steps_out) const {
    const Coord3 place = at(steps_out) + freedom_.inward;
    return freedom_.labelled ? label_at(place) : sign_at(place);
  }

 private:
  [[nodiscard]] Side sign_at(Coord3 place) const {
    Sign sign{};
    domain_.at({&place, 1}, {&sign, 1});
    return sign == Sign::plus ? Side::within : sign == Sign::minus ? Side::beyond : Side::upon;
  }

  [[nodiscard]] Side label_at(Coord3 place) const {
    Material material = 0;
    domain_.materials_at({&place, 1}, {&material, 1});
    const std::int32_t label =
        material == 0 ? 0 : domain_.labels()[static_cast<std::size_t>(material) - 1];
    if (material != 0 && label == freedom_.within) return Side::within;
    if (freedom_.outer ? material == 0 : material != 0 && label == freedom_.beyond)
      return Side::beyond;
    return Side::elsewhere;
  }

  Coord3 position_;
  const Freedom& freedom_;
  const Domain& domain_;
};

}  // namespace

std::optional<Coord3> onto_surface(Coord3 position, const Freedom& freedom, double reach,
                                   const Domain& domain) {
  // Whole numbers of steps, so that halving ends.
  reach = std::ceil(reach);
  const Normal normal(position, freedom, domain);
  const Side own = normal.side(0);
  if (own == Side::upon) return position;
  if (own == Side::elsewhere) return std::nullopt;
  const double direction = own == Side::within ? 1 : -1;
  double near = 0, far = std::min(16.0, reach);
  for (;; near = far, far = std::min(4 * far, reach)) {
    const Side side = normal.side(direction * far);
    if (side == Side::upon) return normal.at(direction * far);
    if (side == Side::elsewhere) return std::nullopt;
    if (side != own) break;
    if (far >= reach) return std::nullopt;
  }
  while (far - near > 1) {
    const double middle = std::floor((near + far) / 2);
    const Side side = normal.side(direction * middle);
    if (side == Side::upon) return normal.at(direction * middle);
    if (side == Side::elsewhere) return std::nullopt;
    (side == own ? near : far) = middle;
  }
  return normal.at(direction * far);
}

}  // namespace certet::optimising
