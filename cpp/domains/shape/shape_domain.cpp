#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "certet/error.hpp"
#include "certet/function_domain.hpp"
#include "certet/shape.hpp"
#include "distances.hpp"
#include "facets.hpp"

namespace certet {
namespace {

using namespace shape;

[[noreturn]] void refuse(const std::string& text, const std::string& reason) {
  throw Error(ErrorCode::bad_option, "the shape '" + text + "' " + reason);
}

using AnyShape =
    std::variant<Sphere, Torus, Box, Cylinder, Within<Gyroid>, Within<Primitive>, Within<Diamond>,
                 Within<Iwp>, Within<Neovius>, Within<Struts>>;

/// Solids without an end, of which a box is taken.
template <class Solid>
constexpr bool is_endless = false;
template <class Solid>
constexpr bool is_endless<Within<Solid>> = true;

using Numbers = std::span<const double>;

Box cube(double a, double b, double c) {
  return {{{-a / 2, -b / 2, -c / 2}, {a / 2, b / 2, c / 2}}};
}

AnyShape torus(const std::string& text, Numbers n) {
  if (n[1] >= n[0]) refuse(text, "has a tube that is not thinner than its ring");
  return Torus{n[0], n[1]};
}

/// A period or cell, a thickness or radius, and the side of a cube, two of the first by default.
template <class Solid>
AnyShape endless(const std::string& text, Numbers n) {
  const Solid solid{n[0], n[1]};
  if (n[1] >= solid.most()) refuse(text, "has parts so thick that they leave no gap");
  const double side = n.size() == 3 ? n[2] : 2 * n[0];
  return Within<Solid>{solid, cube(side, side, side)};
}

/// One kind of shape, and the numbers that it takes.
struct Kind {
  std::string_view name, parameters;
  std::size_t least, most;
  AnyShape (*make)(const std::string& text, Numbers numbers);
};

constexpr std::array kinds{
    Kind{"sphere", "R", 1, 1,
         [](const std::string&, Numbers n) -> AnyShape { return Sphere{n[0]}; }},
    Kind{"torus", "R,r", 2, 2, torus},
    Kind{"box", "a,b,c", 3, 3,
         [](const std::string&, Numbers n) -> AnyShape { return cube(n[0], n[1], n[2]); }},
    Kind{"cylinder", "R,H", 2, 2,
         [](const std::string&, Numbers n) -> AnyShape { return Cylinder{n[0], n[1] / 2}; }},
    Kind{"gyroid", "PERIOD,THICKNESS[,SIDE]", 2, 3, endless<Gyroid>},
    Kind{"primitive", "PERIOD,THICKNESS[,SIDE]", 2, 3, endless<Primitive>},
    Kind{"diamond", "PERIOD,THICKNESS[,SIDE]", 2, 3, endless<Diamond>},
    Kind{"iwp", "PERIOD,THICKNESS[,SIDE]", 2, 3, endless<Iwp>},
    Kind{"neovius", "PERIOD,THICKNESS[,SIDE]", 2, 3, endless<Neovius>},
    Kind{"struts", "CELL,RADIUS[,SIDE]", 2, 3, endless<Struts>},
};

std::string_view name_in(std::string_view text) { return text.substr(0, text.find(':')); }

const Kind& kind_of(const std::string& text) {
  const auto kind = std::ranges::find(kinds, name_in(text), &Kind::name);
  if (kind != kinds.end()) return *kind;
  std::string names;
  for (const Kind& one : kinds) names.append(names.empty() ? "" : ", ").append(one.name);
  refuse(text, "does not exist: there are " + names);
}

std::vector<double> numbers_of(const std::string& text, const Kind& kind) {
  std::vector<double> numbers;
  std::size_t begin = std::min(text.find(':'), text.size());
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(',', begin + 1), text.size());
    double number = 0;
    const auto [stop, failure] =
        std::from_chars(text.data() + begin + 1, text.data() + end, number);
    if (failure != std::errc{} || stop != text.data() + end || !std::isfinite(number) ||
        number <= 0)
      refuse(text, "has a number that is not positive and finite: '" +
                       text.substr(begin + 1, end - begin - 1) + "'");
    numbers.push_back(number);
    begin = end;
  }
  if (numbers.size() < kind.least || numbers.size() > kind.most)
    refuse(text, "has " + std::to_string(numbers.size()) + " numbers: it is " +
                     std::string(kind.name) + ":" + std::string(kind.parameters));
  return numbers;
}

AnyShape read(const std::string& text) {
  const Kind& kind = kind_of(text);
  return kind.make(text, numbers_of(text, kind));
}

template <class Solid>
Bounds bounds_of(const Solid& solid) {
  if constexpr (is_endless<Solid>) return solid.box.sides;
  else return solid.bounds();
}

template <class Solid>
std::optional<double> volume_of(const Solid& solid) {
  if constexpr (is_endless<Solid>) return std::nullopt;
  else return solid.volume();
}

bool fills_a_box(const AnyShape& shape) {
  return std::visit([]<class Solid>(const Solid&) { return is_endless<Solid>; }, shape);
}

/// What has no end has no bounds of its own.
Bounds meet(const std::string& text, const AnyShape& shape, const std::optional<Bounds>& bounds) {
  Bounds result = std::visit([](const auto& solid) { return bounds_of(solid); }, shape);
  if (!bounds) return result;
  if (fills_a_box(shape)) return *bounds;
  for (std::size_t a = 0; a < 3; ++a) {
    result.low[a] = std::max(result.low[a], bounds->low[a]);
    result.high[a] = std::min(result.high[a], bounds->high[a]);
    if (!(result.low[a] < result.high[a])) refuse(text, "has no part within the bounds");
  }
  return result;
}

/// Distances, or less: they change by 1 per world unit at most.
template <class Solid>
std::unique_ptr<Domain> domain(const Solid& solid, const Frame& frame) {
  return std::make_unique<FunctionDomain<Solid>>(solid, frame, 1.0);
}

std::unique_ptr<Domain> domain(const AnyShape& shape, const std::optional<Bounds>& bounds,
                               const Frame& frame) {
  return std::visit(
      [&]<class Solid>(const Solid& solid) -> std::unique_ptr<Domain> {
        if (!bounds) return domain(solid, frame);
        if constexpr (is_endless<Solid>) return domain(Solid{solid.solid, {*bounds}}, frame);
        else return domain(Within<Solid>{solid, {*bounds}}, frame);
      },
      shape);
}

}  // namespace

ShapeDomain::ShapeDomain(const std::string& shape, const std::optional<Bounds>& bounds,
                         double size, std::int32_t margin)
    : ShapeDomain(shape, bounds,
                  lattice_around(meet(shape, read(shape), bounds), size, margin)) {}

ShapeDomain::ShapeDomain(const std::string& shape, const std::optional<Bounds>& bounds,
                         const PlacedLattice& around)
    : around_(around) {
  const AnyShape solid = read(shape);
  bounds_ = meet(shape, solid, bounds);
  if (!bounds)
    volume_ = std::visit([](const auto& one) { return volume_of(one); }, solid);
  if (fills_a_box(solid)) room_ = Box{bounds_}.volume();
  if (bounds)
    border_.push_back(BorderBox::along_frame(around_.frame, bounds->low, bounds->high));
  solid_ = domain(solid, bounds, around_.frame);
  if (!bounds)
    facets_ = std::visit([&](const auto& one) { return facets_of(one, around_.frame); }, solid);
}

bool is_shape(const std::string& text) {
  return text.find(':') != std::string::npos &&
         std::ranges::find(kinds, name_in(text), &Kind::name) != kinds.end();
}

Solid shape_solid(const std::string& shape, const std::optional<Bounds>& bounds) {
  return {meet(shape, read(shape), bounds), [shape, bounds](const PlacedLattice& around) {
            return std::make_shared<ShapeDomain>(shape, bounds, around);
          }};
}

}  // namespace certet
