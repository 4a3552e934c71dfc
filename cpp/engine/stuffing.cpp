#include "certet/stuffing.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "border.hpp"
#include "count.hpp"
#include "cuts.hpp"
#include "emit.hpp"
#include "keep.hpp"
#include "memory.hpp"
#include "piece_count.hpp"
#include "sample.hpp"
#include "share.hpp"
#include "shared_faces.hpp"
#include "settle.hpp"
#include "warped_lattice.hpp"

namespace certet {
namespace {

using namespace core;

/// Faces are told by the one surface of a mesh.
void refuse_interfaces(const Stuffing& stuffing) {
  if (stuffing.has_interfaces())
    throw Error(ErrorCode::bad_option, "the faces of a mesh that has interfaces are not told");
  if (stuffing.grading_levels() != 0)
    throw Error(ErrorCode::bad_option, "the faces of a graded mesh are not told");
}

/// What looks at the whole mesh is not told by those who have a share of it.
void refuse_share(const Stuffing& stuffing) {
  if (!stuffing.knows_all())
    throw Error(ErrorCode::bad_option, "this is told of a whole mesh, not of a rank's share of one");
}

/// The lattice is checked once, here; every coordinate that the engine computes
/// afterwards is in range: `DoorSuffices` of the certificate.
void check_range(const Lattice& lattice) {
  const Coord3& o = lattice.origin;
  if ((o.x | o.y | o.z) & 1) throw Error(ErrorCode::bad_option, "the lattice origin is not even");
  const std::array<std::int32_t, 3> low{o.x, o.y, o.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t n = lattice.cells[axis];
    if (n < 2) throw Error(ErrorCode::bad_option, "the lattice has fewer than two cells along an axis");
    const std::int64_t high = low[axis] + 2 * n + 1;
    if (low[axis] < -anchor_limit || high > anchor_limit)
      throw Error(ErrorCode::too_large,
                  "the lattice needs " + std::to_string(n) +
                      " cells along an axis, which leaves the coordinate range of ±" +
                      std::to_string(anchor_limit / 2) + " cells");
  }
}

template <class Work>
auto within_memory(const Work& work) {
  return core::within_memory("the mesh does not fit in memory", work);
}

}  // namespace

struct Stuffing::State {
  const Domain& domain;
  Lattice lattice;
  WarpedLattice warped;
  RowNumbers numbers;
  Method method;
  std::uint64_t inverted_tets = 0;
  std::unique_ptr<const GradedCells> graded = {};
  std::uint64_t uniform_tets = 0;  ///< of a graded mesh
  std::optional<Share> share = {};  ///< none: one has all
};

namespace {

static_assert(facts(Method::midpoint).thresholds.long_edge == 0 &&
                  facts(Method::midpoint).thresholds.short_edge == 0,
              "with cuts in the middle no cut violates a vertex");

/// The layers that are made here: those of a rank and, for its tetrahedra, the layer behind them.
struct MadeLayers {
  Window own, made;
  Ranks* ranks;  ///< null: one has all

  [[nodiscard]] std::uint64_t sum(std::uint64_t own_count) const {
    if (ranks == nullptr) return own_count;
    const std::vector<std::uint64_t> each = gather_each(*ranks, own_count);
    return std::accumulate(each.begin(), each.end(), std::uint64_t{0});
  }
};

MadeLayers all_layers(const Lattice& lattice) { return {whole(lattice), whole(lattice), nullptr}; }

MadeLayers layers_of(Window own, const Lattice& lattice, Ranks& ranks) {
  return {own, widened(own, 0, 1, lattice), &ranks};
}

/// How many layers more a method looks at.
std::int32_t halo_of(Method method) { return facts(method).settles ? settling_halo : 0; }

/// With its violated vertices settled.  Diagonals that follow the cuts are of one
/// material: on a tetrahedron that two share each would have its own, so where several meet
/// `key` falls back to `embedded`.
WarpedLattice settled_lattice(const SignPlanes& planes, const Layers<CutLayer>& cuts,
                              const Lattice& lattice, const MadeLayers& parts, Method& method,
                              Context& context) {
  if (method == Method::key && planes.materials() != nullptr) method = Method::embedded;
  const Thresholds& thresholds = facts(method).thresholds;
  Violations violations = find_violations(
      planes, cuts, violation_window(parts.made, lattice, settling_halo), thresholds, context);
  Settling settling = settle(planes, violations, thresholds, lattice, parts.own, context);
  WarpedLattice warped = warp_lattice({planes, std::move(settling.planes)}, violations, cuts,
                                      thresholds, lattice, parts.made, parts.own, context);
  warped.figures.add(settling.figures);
  warped.diagonals_follow_cuts = facts(method).diagonals_follow_cuts;
  return warped;
}

/// By the paper's rule, all violated vertices moved; `angles` falls back to `embedding` if a
/// tetrahedron that is dropped came out inverted, for it would cover others.
WarpedLattice moved_lattice(const SignPlanes& planes, const Layers<CutLayer>& cuts,
                            const Lattice& lattice, const MadeLayers& parts, Method& method,
                            std::uint64_t& inverted, Context& context) {
  const Window around = violation_window(parts.made, lattice, 0);
  const auto warp = [&](const Violations& violations, SignPlanes moved) {
    return warp_lattice({planes, std::move(moved)}, violations, cuts, no_warp_thresholds, lattice,
                        parts.made, context);
  };
  if (method == Method::angles) {
    const Violations violations =
        find_violations(planes, cuts, around, facts(method).thresholds, context);
    SignPlanes moved = move_all(planes, violations, context);
    inverted = parts.sum(inverted_tets(moved, violations, lattice, parts.own, context));
    if (inverted == 0) return warp(violations, std::move(moved));
    method = Method::embedding;
  }
  const Violations violations =
      find_violations(planes, cuts, around, facts(method).thresholds, context);
  return warp(violations, move_all(planes, violations, context));
}

/// `method` becomes the one that was used in the end.
WarpedLattice warped_lattice(const Domain& domain, const Lattice& lattice, const MadeLayers& parts,
                             Method& method, std::uint64_t& inverted, Context& context) {
  const MethodFacts& asked = facts(method);
  const std::int32_t halo = halo_of(method);
  SignPlanes planes =
      sample(domain, lattice, sampled_window(parts.made, lattice, halo), asked, context);
  const Window cut = asked.cuts == Cuts::midpoint ? parts.made : cut_window(parts.made, lattice, halo);
  Layers<CutLayer> cuts = find_cuts(planes, domain, lattice, cut, asked.cuts, context);
  if (asked.cuts == Cuts::midpoint) return unwarped(std::move(planes), std::move(cuts), parts.made);
  return asked.settles
             ? settled_lattice(planes, cuts, lattice, parts, method, context)
             : moved_lattice(planes, cuts, lattice, parts, method, inverted, context);
}

/// Of all ranks.
WarpFigures sum(const WarpFigures& own, Ranks& ranks) {
  WarpFigures all;
  for (const WarpFigures& figures : gather_each(ranks, own)) all.add(figures);
  return all;
}

}  // namespace

Stuffing::Stuffing(const Domain& domain, const Lattice& lattice, Method method,
                   Context& context) {
  check_range(lattice);
  state_ = within_memory([&] {
    std::uint64_t inverted = 0;
    WarpedLattice warped =
        warped_lattice(domain, lattice, all_layers(lattice), method, inverted, context);
    RowNumbers numbers(warped.planes, lattice, whole(lattice), context);
    return std::make_unique<State>(
        State{domain, lattice, std::move(warped), std::move(numbers), method, inverted});
  });
}

Stuffing::Stuffing(const Domain& domain, const Lattice& lattice, Method method, Ranks& ranks,
                   Context& context) {
  check_range(lattice);
  state_ = within_memory([&] {
    std::uint64_t inverted = 0;
    const MadeLayers parts = layers_of(balanced_window(domain, lattice, facts(method), ranks, context),
                                 lattice, ranks);
    WarpedLattice warped = warped_lattice(domain, lattice, parts, method, inverted, context);
    warped.figures = sum(warped.figures, ranks);
    RowNumbers numbers(warped.planes, lattice, parts.made, context);
    const Share share = numbered_share(numbers, parts.own, ranks);
    auto state = std::make_unique<State>(
        State{domain, lattice, std::move(warped), std::move(numbers), method, inverted});
    state->share = share;
    return state;
  });
}

void Stuffing::divide(Ranks& ranks) {
  refuse_share(*this);
  const State& s = *state_;
  state_->share = Share{&ranks, balanced_window(s.numbers, s.lattice, ranks), true,
                        s.numbers.point_count(), s.numbers.tet_count()};
}

Stuffing::Stuffing(std::unique_ptr<State> state) : state_(std::move(state)) {}

Stuffing::~Stuffing() = default;
Stuffing::Stuffing(Stuffing&&) noexcept = default;
Stuffing& Stuffing::operator=(Stuffing&&) noexcept = default;

std::uint64_t Stuffing::point_count() const {
  return state_->share ? state_->share->points : state_->numbers.point_count();
}
std::uint64_t Stuffing::tet_count() const {
  return state_->share ? state_->share->tets : state_->numbers.tet_count();
}
Ranks* Stuffing::ranks() const { return state_->share ? state_->share->ranks : nullptr; }
bool Stuffing::knows_all() const { return !state_->share || state_->share->knows_all; }
std::int32_t Stuffing::own_begin() const { return state_->share ? state_->share->own.begin : 0; }
std::int32_t Stuffing::own_end() const {
  return state_->share ? state_->share->own.end : layers();
}
const Lattice& Stuffing::lattice() const { return state_->lattice; }
Method Stuffing::method() const { return state_->method; }
std::uint64_t Stuffing::inverted_tets() const { return state_->inverted_tets; }
const WarpFigures& Stuffing::warp_figures() const { return state_->warped.figures; }
std::int32_t Stuffing::layers() const { return state_->lattice.cells[2]; }

std::uint64_t Stuffing::first_point(std::int32_t layer) const {
  return state_->numbers.first_point(0, layer);
}
std::uint64_t Stuffing::first_tet(std::int32_t layer) const {
  return state_->numbers.first_tet(0, layer);
}

std::int32_t Stuffing::points_end(std::int32_t end) const {
  const std::int32_t behind = state_->graded ? state_->graded->layers_behind() : 1;
  return std::min(end + behind, layers());
}

void Stuffing::emit_points(std::int32_t begin, std::int32_t end, std::span<Coord3> out,
                           Context& context) const {
  core::emit_points(state_->warped, state_->numbers, state_->lattice, {begin, end}, out, context);
}

void Stuffing::mark_surface(std::int32_t begin, std::int32_t end, std::span<std::uint8_t> out,
                            Context& context) const {
  core::mark_surface(state_->warped, state_->numbers, state_->lattice, {begin, end}, out, context);
}

void Stuffing::emit_tets(std::int32_t begin, std::int32_t end,
                         std::span<Tet<std::uint32_t>> out, Context& context) const {
  core::emit_tets(state_->warped, state_->numbers, state_->lattice, {begin, end}, out, context);
}

void Stuffing::emit_tets(std::int32_t begin, std::int32_t end,
                         std::span<Tet<std::uint64_t>> out, Context& context) const {
  core::emit_tets(state_->warped, state_->numbers, state_->lattice, {begin, end}, out, context);
}

std::span<const std::int32_t> Stuffing::labels() const { return state_->domain.labels(); }

void Stuffing::emit_materials(std::int32_t begin, std::int32_t end,
                              std::span<const Coord3> points,
                              std::span<const Tet<std::uint32_t>> tets, std::span<Material> out,
                              Context& context) const {
  core::emit_materials(state_->domain, state_->numbers, state_->lattice, {begin, end}, points,
                       tets, out, context);
}

void Stuffing::emit_materials(std::int32_t begin, std::int32_t end,
                              std::span<const Coord3> points,
                              std::span<const Tet<std::uint64_t>> tets, std::span<Material> out,
                              Context& context) const {
  core::emit_materials(state_->domain, state_->numbers, state_->lattice, {begin, end}, points,
                       tets, out, context);
}

bool Stuffing::has_interfaces() const { return state_->warped.planes.materials() != nullptr; }

void Stuffing::emit_materials(std::int32_t begin, std::int32_t end, std::span<Material> out,
                              Context& context) const {
  core::emit_materials(state_->warped.planes, state_->numbers, state_->lattice, {begin, end}, out,
                       context);
}

void Stuffing::materials_of(std::span<const TetCorners> tets, std::span<Material> out) const {
  if (labels().size() <= 1)
    std::ranges::fill(out, 1);
  else
    state_->domain.materials_of(tets, out);
}

Pieces Stuffing::pieces(const Frame& frame, Context& context) const {
  refuse_share(*this);
  return within_memory([&] {
    const State& s = *state_;
    return count_pieces(s.warped, s.lattice, labels(), uniform_tet_count(), frame, context);
  });
}

void Stuffing::grade(const Grading& grading, Context& context) {
  refuse_share(*this);
  const std::int32_t levels = grading.levels;
  if (levels < 0 || levels > most_grading_levels)
    throw Error(ErrorCode::bad_option, "a mesh is graded by 0 to " +
                                           std::to_string(most_grading_levels) + " levels");
  if (levels != 0 && grid_count != 2)
    throw Error(ErrorCode::bad_option, "this tiling has no cells that a mesh is graded by");
  if (levels != 0 && labels().size() > 1 && !has_interfaces())
    throw Error(ErrorCode::bad_option,
                "a mesh is graded where its materials meet in common interfaces");
  within_memory([&] {
    State& s = *state_;
    const Window all = whole(s.lattice);
    auto graded = levels == 0 ? nullptr
                              : std::make_unique<const GradedCells>(s.warped.planes, s.lattice,
                                                                    grading, context);
    RowNumbers numbers =
        s.graded ? RowNumbers(s.warped.planes, s.lattice, all, context) : s.numbers;
    if (graded) numbers = RowNumbers(numbers, s.warped.planes, s.lattice, context, *graded);
    s.uniform_tets = uniform_tet_count();
    s.numbers = std::move(numbers);
    s.graded = std::move(graded);
  });
}

std::int32_t Stuffing::grading_levels() const {
  return state_->graded ? state_->graded->octree().top() : 0;
}

std::uint64_t Stuffing::uniform_tet_count() const {
  return state_->graded ? state_->uniform_tets : tet_count();
}

void Stuffing::visit_faces_within(std::int32_t layer, const VisitTetPairs& visit) const {
  refuse_interfaces(*this);
  LayerTets(state_->warped, layer).visit_within(visit);
}

void Stuffing::visit_faces_between(std::int32_t layer, const VisitTetPairs& visit) const {
  refuse_interfaces(*this);
  const WarpedLattice& warped = state_->warped;
  if (layer + 1 < layers())
    LayerTets(warped, layer).visit_between(LayerTets(warped, layer + 1), visit);
}

Stuffing Stuffing::keep(const KeepRule& rule, Context& context) {
  refuse_share(*this);
  return within_memory([&] {
    const State& old = *state_;
    const auto state_of = [&](WarpedLattice warped) {
      RowNumbers numbers(warped.planes, old.lattice, whole(old.lattice), context);
      return std::make_unique<State>(State{old.domain, old.lattice, std::move(warped),
                                           std::move(numbers), old.method, old.inverted_tets});
    };
    auto [kept, rest] = split(old.warped, old.lattice, rule, context);
    auto state = state_of(std::move(kept));
    Stuffing dropped(state_of(std::move(rest)));
    state_ = std::move(state);
    return dropped;
  });
}

std::span<const BorderBox> Stuffing::border() const { return state_->domain.border(); }

bool Stuffing::is_on_border(Coord3 point) const {
  return core::is_on_border(point, state_->domain.border(), facts(state_->method).cuts);
}

std::uint64_t Stuffing::bytes() const {
  const State& s = *state_;
  std::uint64_t bytes = s.warped.planes.bytes() + s.numbers.bytes();
  if (s.graded) bytes += s.graded->bytes();
  for (const CutLayer& layer : s.warped.cuts)
    bytes += 2 * layer.steps.size() + 8 * layer.row_begin.size();
  for (const DisplacedLayer& layer : s.warped.zeros)
    bytes += sizeof(Displacement) * layer.displacements.size() + 4 * layer.row_begin.size();
  return bytes;
}

Mesh emit(const Stuffing& stuffing, const Frame& frame, Context& context) {
  refuse_share(stuffing);
  checked_size(frame.size);
  return within_memory([&] {
    Mesh mesh;
    mesh.frame = frame;
    mesh.method = stuffing.method();
    mesh.points = Buffer<Coord3>(stuffing.point_count());
    stuffing.emit_points(0, stuffing.layers(), mesh.points, context);
    const auto emit_tets = [&]<class Index>(Index) {
      Buffer<Tet<Index>> tets(stuffing.tet_count());
      stuffing.emit_tets(0, stuffing.layers(), std::span<Tet<Index>>(tets), context);
      if (!stuffing.labels().empty()) {
        mesh.labels = Buffer<std::int32_t>(tets.size());
        if (stuffing.has_interfaces())
          stuffing.emit_materials(0, stuffing.layers(), mesh.labels, context);
        else
          stuffing.emit_materials(0, stuffing.layers(), mesh.points,
                                  std::span<const Tet<Index>>(tets), mesh.labels, context);
        labels_in_place(std::span(mesh.labels), stuffing.labels(),
                        [](std::int32_t, std::uint64_t) {});
      }
      mesh.tets = std::move(tets);
    };
    if (stuffing.point_count() <= std::numeric_limits<std::uint32_t>::max())
      emit_tets(std::uint32_t{});
    else
      emit_tets(std::uint64_t{});
    return mesh;
  });
}

namespace {

void refuse_empty(const Stuffing& stuffing) {
  if (stuffing.tet_count() == 0)
    throw Error(ErrorCode::empty_domain, "nothing is inside at this size, so there is no mesh");
}

}  // namespace

Mesh stuff(const Domain& domain, const Lattice& lattice, const Frame& frame, Method method,
           Context& context) {
  const Stuffing stuffing(domain, lattice, method, context);
  refuse_empty(stuffing);
  return emit(stuffing, frame, context);
}

Mesh mesh(const PlacedDomain& domain, const Stuffing& stuffing, Context& context) {
  refuse_empty(stuffing);
  Mesh mesh = emit(stuffing, domain.frame(), context);
  mesh.names = domain.names();
  mesh.border.assign(domain.border().begin(), domain.border().end());
  return mesh;
}

Mesh mesh(const PlacedDomain& domain, Method method, Context& context) {
  return mesh(domain, Stuffing(domain, domain.lattice(), method, context), context);
}

Mesh mesh(const PlacedDomain& domain, Method method) {
  Context context;
  return mesh(domain, method, context);
}

Buffer<Point3> world_points(const Mesh& mesh) {
  return within_memory([&] {
    Buffer<Point3> world(mesh.points.size());
    std::ranges::transform(mesh.points, world.begin(),
                           [&](Coord3 position) { return mesh.frame.world(position); });
    return world;
  });
}

}  // namespace certet
