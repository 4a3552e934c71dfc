#include "certified.hpp"

#include <type_traits>

#include "closures.hpp"
#include "narrow.hpp"
#include "runtime.hpp"

namespace certified {
namespace {

using runtime::call_int;
using runtime::call_ints;
using runtime::Frame;

/// Takes the numbers of an answer one by one.
class Reader {
 public:
  explicit Reader(std::vector<std::int64_t> numbers) : numbers_(std::move(numbers)) {}
  [[nodiscard]] bool done() const { return next_ == numbers_.size(); }
  std::int64_t number() { return numbers_.at(next_++); }
  Coord3 coord3() {
    const std::int32_t x = narrow(number());
    const std::int32_t y = narrow(number());
    const std::int32_t z = narrow(number());
    return {x, y, z};
  }
  Thresholds thresholds() {
    const std::int64_t long_edge = number();
    return {long_edge, number()};
  }

 private:
  std::vector<std::int64_t> numbers_;
  std::size_t next_ = 0;
};

std::int64_t number(certet::StructuredTetCase orientation) {
  return static_cast<std::int64_t>(orientation);
}

/// What a certified function places, called with a frame for the domain and these numbers.
template <class Closures>
auto placed_by(const char* name, const auto& domain, const auto&... numbers) {
  std::remove_reference_t<decltype(Closures::out)> placed;
  const Closures closures{domain, placed};
  Frame frame(&closures);
  runtime::call(name, {frame.handle(), static_cast<std::int64_t>(numbers)...}, &frame);
  return placed;
}

}  // namespace

void start() { runtime::start(); }

Constants constants() {
  Reader reader(call_ints("certified.constants", {}));
  Constants c{};
  c.step_bits = reader.number();
  c.steps = reader.number();
  c.midpoint_cut = reader.number();
  c.angle = reader.thresholds();
  c.embedding = reader.thresholds();
  c.no_warp = reader.thresholds();
  c.key = reader.thresholds();
  for (Direction& d : c.directions) {
    d.offset = reader.coord3();
    d.is_long = reader.number() != 0;
    d.length_squared = reader.number();
  }
  if (!reader.done()) throw Failure("there are more than fourteen directions");
  return c;
}

std::int64_t threshold_steps(Thresholds t, bool is_long) {
  return call_int("certified.threshold_steps", {t.long_edge, t.short_edge, is_long ? 1 : 0});
}

std::vector<certet::StructuredTetCase> all_cases() {
  std::vector<certet::StructuredTetCase> cases;
  const std::int64_t count = call_int("certified.case_count", {});
  for (std::int64_t i = 0; i < count; ++i)
    cases.push_back(static_cast<certet::StructuredTetCase>(i));
  return cases;
}

bool right_handed(certet::StructuredTetCase orientation) {
  return call_int("certified.right_handed", {number(orientation)}) != 0;
}

certet::StructuredTet structured_tet(const certet::StructuredTetId& id) {
  const auto& [anchor, orientation] = id;
  Reader reader(call_ints("certified.structured_tet",
                          {anchor.x, anchor.y, anchor.z, number(orientation)}));
  certet::StructuredTet tet{};
  for (Coord3& v : tet.vertices) v = reader.coord3();
  for (certet::FaceNeighbor& n : tet.neighbors) {
    n.id.anchor = reader.coord3();
    n.id.orientation = static_cast<certet::StructuredTetCase>(reader.number());
    for (std::uint8_t& place : n.order) place = static_cast<std::uint8_t>(reader.number());
  }
  return tet;
}

namespace {

std::vector<std::array<Handle, 4>> tets_by(const char* function,
                                           const closures::Stencil& closures,
                                           const std::array<Handle, 4>& v) {
  Frame frame(&closures);
  Reader reader(call_ints(function, {frame.handle(), v[0], v[1], v[2], v[3]}, &frame));
  std::vector<std::array<Handle, 4>> tets;
  while (!reader.done())
    for (Handle& vertex : tets.emplace_back()) vertex = reader.number();
  return tets;
}

}  // namespace

std::vector<std::array<Handle, 4>> unstructured_tets(
    const GetSign& get_sign, const GetIntersection& get_intersection,
    const std::array<Handle, 4>& vertices) {
  return tets_by("certified.unstructured_tets", {get_sign, get_intersection}, vertices);
}

std::vector<std::array<Handle, 4>> key_tets(const GetSign& get_sign,
                                            const GetIntersection& get_intersection,
                                            const GetKey& get_key,
                                            const std::array<Handle, 4>& vertices) {
  return tets_by("certified.key_tets", {get_sign, get_intersection, &get_key}, vertices);
}

std::vector<OfMaterial<Handle>> material_tets(const GetMaterial& get_material,
                                              const GetIntersection& get_intersection,
                                              const std::array<Handle, 4>& v, Material shared) {
  const closures::MaterialStencil closures{get_material, get_intersection};
  Frame frame(&closures);
  Reader reader(call_ints("certified.material_tets",
                          {frame.handle(), v[0], v[1], v[2], v[3], shared}, &frame));
  std::vector<OfMaterial<Handle>> tets;
  while (!reader.done()) {
    auto& [material, vertices] = tets.emplace_back();
    material = reader.number();
    for (Handle& vertex : vertices) vertex = reader.number();
  }
  return tets;
}

Warping warp(Thresholds t, Sign sign, const std::function<Sign(int)>& neighbor_sign,
             const std::function<std::int64_t(int)>& cut) {
  const closures::Warp closures{neighbor_sign, cut};
  Frame frame(&closures);
  Reader reader(call_ints(
      "certified.warp",
      {frame.handle(), t.long_edge, t.short_edge, static_cast<std::int64_t>(sign)}, &frame));
  const std::int64_t direction = reader.number();
  return {static_cast<int>(direction), reader.number()};
}

Sign warped_sign(Sign sign, Warping w) {
  return static_cast<Sign>(call_int("certified.warped_sign",
                                    {static_cast<std::int64_t>(sign), w.direction, w.distance}));
}

Coord3 warped_position(Coord3 v, Warping w) {
  return Reader(call_ints("certified.warped_position",
                          {v.x, v.y, v.z, w.direction, w.distance}))
      .coord3();
}

bool is_disk(const std::array<Sign, certet::direction_count>& link) {
  std::int64_t signs = 0;  // two bits each
  for (std::size_t d = 0; d < link.size(); ++d)
    signs |= static_cast<std::int64_t>(link[d]) << (2 * d);
  return call_int("certified.is_disk", {signs}) != 0;
}

std::vector<LinkSet> disks(LinkSet plus) {
  std::vector<LinkSet> found;
  for (const std::int64_t set : call_ints("certified.disks", {plus}))
    found.push_back(static_cast<LinkSet>(set));
  return found;
}

bool in_one_piece(LinkSet set) { return call_int("certified.in_one_piece", {set}) != 0; }

std::int64_t bisect(const std::function<Sign(std::int64_t)>& sign) {
  const closures::Bisect closures{sign};
  Frame frame(&closures);
  return call_int("certified.bisect", {frame.handle()}, &frame);
}

Coord3 point_on_edge(Coord3 a, Coord3 b, std::int64_t t) {
  return Reader(call_ints("certified.point_on_edge", {a.x, a.y, a.z, b.x, b.y, b.z, t}))
      .coord3();
}

std::vector<PlacedTet> stuff_tet(Thresholds t, const Domain& domain,
                                 const certet::StructuredTetId& id) {
  return placed_by<closures::Stuffing>("certified.stuff_tet", domain, t.long_edge, t.short_edge,
                                       id.anchor.x, id.anchor.y, id.anchor.z,
                                       number(id.orientation));
}

std::vector<PlacedTet> stuff(Thresholds t, const certet::Lattice& lattice,
                             const Domain& domain) {
  const auto& [o, cells] = lattice;
  return placed_by<closures::Stuffing>("certified.stuff", domain, t.long_edge, t.short_edge, o.x,
                                       o.y, o.z, cells[0], cells[1], cells[2]);
}

bool is_well_shaped(const PlacedTet& tet) {
  const auto& [a, b, c, d] = tet;
  return call_int("certified.is_well_shaped", {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x,
                                               d.y, d.z}) != 0;
}

Sign voxel_sign(const VoxelGrid& grid, const std::function<bool(Coord3)>& holds, Coord3 point) {
  const closures::Voxels closures{holds};
  Frame frame(&closures);
  const auto& [half, s, o] = grid;
  return static_cast<Sign>(call_int(
      "certified.voxel_sign",
      {frame.handle(), half, s.x, s.y, s.z, o.x, o.y, o.z, point.x, point.y, point.z}, &frame));
}

std::vector<PlacedTet> settle(Thresholds t, Gap gap, const certet::Lattice& lattice,
                              const Domain& domain, Diagonals diagonals) {
  const auto& [o, cells] = lattice;
  return placed_by<closures::Stuffing>("certified.settle", domain, t.long_edge, t.short_edge,
                                       gap == Gap::strict, diagonals == Diagonals::by_key, o.x,
                                       o.y, o.z, cells[0], cells[1], cells[2]);
}

std::vector<PlacedTet> grade(Thresholds t, bool settles, int levels,
                             const certet::Lattice& lattice, const Domain& domain,
                             Diagonals diagonals) {
  std::vector<PlacedTet> tets;
  const closures::Stuffing closures{domain, tets};
  Frame frame(&closures);
  const auto& [origin, cells] = lattice;
  runtime::call("certified.grade",
                {frame.handle(), t.long_edge, t.short_edge, settles ? 1 : 0,
                 diagonals == Diagonals::by_key ? 1 : 0, levels, origin.x, origin.y, origin.z,
                 cells[0], cells[1], cells[2]},
                &frame);
  return tets;
}

std::vector<PlacedMaterialTet> settle_materials(Thresholds t, const certet::Lattice& lattice,
                                                const MaterialDomain& domain) {
  const auto& [o, cells] = lattice;
  return placed_by<closures::MaterialMesh>("certified.settle_materials", domain, t.long_edge,
                                           t.short_edge, o.x, o.y, o.z, cells[0], cells[1],
                                           cells[2]);
}

std::vector<PlacedMaterialTet> grade_materials(Thresholds t, bool settles, int levels,
                                               const certet::Lattice& lattice,
                                               const MaterialDomain& domain) {
  const auto& [o, cells] = lattice;
  return placed_by<closures::MaterialMesh>("certified.grade_materials", domain, t.long_edge,
                                           t.short_edge, settles ? 1 : 0, levels, o.x, o.y, o.z,
                                           cells[0], cells[1], cells[2]);
}

std::vector<PlacedMaterialTet> halve_materials(
    const certet::Lattice& lattice, const std::function<Material(Coord3)>& material) {
  const auto& [o, cells] = lattice;
  return placed_by<closures::MaterialMesh>("certified.halve_materials",
                                           MaterialDomain{material, {}}, o.x, o.y, o.z, cells[0],
                                           cells[1], cells[2]);
}

}  // namespace certified
