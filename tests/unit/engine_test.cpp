/// The engine: pieces, threads, index widths and errors.  That its meshes are
/// the certified ones is the differential tests' business.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "certet/error.hpp"
#include "certet/lattice/orientation.hpp"
#include "certet/lattice/structured_tet.hpp"
#include "certet/stuffing.hpp"
#include "engine/parallel.hpp"
#include "engine/sign_planes.hpp"
#include "domains.hpp"

namespace certet {
namespace {

domains::Positional ball(double radius) {
  return domains::of_level(domains::sphere(0, 0, 0, radius));
}

constexpr Lattice around_origin(int half) {
  return {{-2 * half, -2 * half, -2 * half}, {2 * half, 2 * half, 2 * half}};
}

bool same_points(std::span<const Coord3> a, std::span<const Coord3> b) {
  return std::ranges::equal(a, b);
}

template <class Index>
std::span<const Tet<Index>> tets_of(const Mesh& mesh) {
  return std::get<Buffer<Tet<Index>>>(mesh.tets);
}

bool same(const Mesh& a, const Mesh& b) {
  return same_points(a.points, b.points) &&
         std::ranges::equal(tets_of<std::uint32_t>(a), tets_of<std::uint32_t>(b));
}

Mesh mesh_of(const Domain& domain, const Lattice& lattice, int threads = 1,
             Method method = {}) {
  Context context;
  context.threads = threads;
  return stuff(domain, lattice, {}, method, context);
}

TEST(Engine, AnyNumberOfThreadsGivesTheSameMesh) {
  const auto domain = domains::of_level(domains::torus(0, 0, 0, 40, 15));
  const Lattice lattice = around_origin(32);
  const Mesh one = mesh_of(domain, lattice, 1);
  EXPECT_GT(one.tet_count(), 10'000u);
  for (const int threads : {2, 3, 8}) EXPECT_TRUE(same(one, mesh_of(domain, lattice, threads)));
}

TEST(Engine, SlabsAddUpToTheWhole) {
  const auto domain = domains::noise(7, 16);
  const Lattice lattice = around_origin(8);
  const Mesh whole = mesh_of(domain, lattice);
  Context context;
  const Stuffing stuffing(domain, lattice, {}, context);
  for (const int height : {1, 2, 5}) {
    for (int begin = 0; begin < stuffing.layers(); begin += height) {
      const int end = std::min(begin + height, stuffing.layers());
      const std::uint64_t p = stuffing.first_point(begin);
      const std::uint64_t t = stuffing.first_tet(begin);
      std::vector<Coord3> points(stuffing.first_point(end) - p);
      std::vector<Tet<std::uint32_t>> tets(stuffing.first_tet(end) - t);
      stuffing.emit_points(begin, end, points, context);
      stuffing.emit_tets(begin, end, std::span(tets), context);
      EXPECT_TRUE(same_points(points, std::span(whole.points).subspan(p, points.size())));
      EXPECT_TRUE(std::ranges::equal(
          tets, tets_of<std::uint32_t>(whole).subspan(t, tets.size())));
    }
  }
}

TEST(Engine, TetrahedraOfALayerUseItsPointsAndTheNextLayersOnly) {
  const auto domain = domains::noise(11, 16);
  Context context;
  const Stuffing stuffing(domain, around_origin(8), {}, context);
  const int layers = stuffing.layers();
  for (int k = 0; k < layers; ++k) {
    std::vector<Tet<std::uint32_t>> tets(stuffing.first_tet(k + 1) - stuffing.first_tet(k));
    stuffing.emit_tets(k, k + 1, std::span(tets), context);
    for (const auto& tet : tets)
      for (const std::uint64_t point : tet) {
        EXPECT_GE(point, stuffing.first_point(k));
        EXPECT_LT(point, stuffing.first_point(std::min(k + 2, layers)));
      }
  }
}

std::vector<std::uint8_t> surface_marks(const Stuffing& stuffing, Context& context) {
  std::vector<std::uint8_t> marks(stuffing.point_count());
  stuffing.mark_surface(0, stuffing.layers(), marks, context);
  return marks;
}

bool is_lattice_point(Coord3 position) {
  const auto odd = [](std::int32_t c) { return (c / steps) % 2 != 0; };
  return position.x % steps == 0 && position.y % steps == 0 && position.z % steps == 0 &&
         odd(position.x) == odd(position.y) && odd(position.y) == odd(position.z);
}

/// A point is off the surface if and only if it is a lattice point that is plus.
TEST(Engine, PointsOnTheSurfaceAreMarked) {
  const auto domain = domains::noise(5, 16);
  for (const Lattice& lattice : {around_origin(8), Lattice{{-20, 4, 6}, {70, 3, 3}}}) {
    Context context;
    const Stuffing stuffing(domain, lattice, {}, context);
    const std::vector<std::uint8_t> marks = surface_marks(stuffing, context);
    const Mesh mesh = emit(stuffing, {}, context);
    std::size_t inner = 0;
    for (std::size_t p = 0; p < marks.size(); ++p) {
      const bool plus = is_lattice_point(mesh.points[p]) && domain.sign_at(mesh.points[p]) == Sign::plus;
      EXPECT_EQ(marks[p], plus ? 0 : 1) << "point " << p;
      inner += plus;
    }
    EXPECT_GT(inner, 0u);
    EXPECT_LT(inner, marks.size());
  }
}

/// A cube between even planes: the surface passes through even vertices, and
/// through the middle of the long edges between odd ones.
TEST(Engine, ItTellsTheBytesThatItHolds) {
  const domains::Positional cube([](Coord3 p) {
    const std::int32_t far = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return far < 12 * steps ? Sign::plus : far == 12 * steps ? Sign::on_surface : Sign::minus;
  });
  const domains::Positional nowhere([](Coord3) { return Sign::minus; });
  const Lattice lattice = around_origin(16);
  Context context;
  const Stuffing empty(nowhere, lattice, {}, context);
  const Stuffing stuffing(cube, lattice, {}, context);
  std::uint64_t cuts = 0;
  std::uint64_t zeros = 0;
  const std::vector<std::uint8_t> marks = surface_marks(stuffing, context);
  const Mesh mesh = emit(stuffing, {}, context);
  for (std::size_t p = 0; p < marks.size(); ++p)
    if (marks[p] == 1) ++(is_lattice_point(mesh.points[p]) ? zeros : cuts);
  EXPECT_GT(cuts, 500u);
  EXPECT_GT(zeros, 500u);
  EXPECT_EQ(stuffing.bytes() - empty.bytes(), 2 * cuts + 4 * zeros);

  const auto rows = static_cast<std::uint64_t>(empty.layers()) * static_cast<std::uint64_t>(empty.layers());
  const std::int32_t points = empty.layers();
  EXPECT_EQ(empty.bytes(), core::SignPlanes::bytes_for({points, points, points}) +
                               rows * (8 + 4)            // where a row's cuts and zeros begin
                               + 2 * 8 * (rows + 1));    // its first point and tetrahedron
}

TEST(Engine, SixtyFourBitIndicesAreTheSameNumbers) {
  const auto domain = ball(11.3);
  Context context;
  const Stuffing stuffing(domain, around_origin(8), {}, context);
  std::vector<Tet<std::uint32_t>> narrow(stuffing.tet_count());
  std::vector<Tet<std::uint64_t>> wide(stuffing.tet_count());
  stuffing.emit_tets(0, stuffing.layers(), std::span(narrow), context);
  stuffing.emit_tets(0, stuffing.layers(), std::span(wide), context);
  for (std::size_t t = 0; t < narrow.size(); ++t)
    EXPECT_TRUE(std::ranges::equal(narrow[t], wide[t]));
}

/// A ball that knows which boxes lie inside or outside it.
class BoundedBall : public domains::Positional {
 public:
  explicit BoundedBall(double radius) : Positional(ball(radius)), radius_(radius) {}
  Extent extent(const LatticeBox& box) const override {
    double nearest = 0;
    double farthest = 0;
    for (const auto& [low, high] : {std::pair{box.low.x, box.high.x}, {box.low.y, box.high.y},
                                    {box.low.z, box.high.z}}) {
      const double near = low > 0 ? low : high < 0 ? -high : 0;
      const double far = std::max(std::abs(low), std::abs(high));
      nearest += near * near;
      farthest += far * far;
    }
    if (farthest < radius_ * radius_) return Extent::inside;
    return nearest > radius_ * radius_ ? Extent::outside : Extent::mixed;
  }

 private:
  double radius_;
};

TEST(Engine, BlocksSkippedByABoundChangeNothing) {
  for (const double radius : {3.0, 40.5, 61.0})
    EXPECT_TRUE(same(mesh_of(ball(radius), around_origin(36)),
                     mesh_of(BoundedBall(radius), around_origin(36))));
}

TEST(Engine, TheWordsOfTheBitPlanesDoNotShow) {
  const auto domain = ball(33.7);
  const Mesh plain = mesh_of(domain, around_origin(18));
  for (int shift = 1; shift <= 65; ++shift)
    EXPECT_TRUE(same(plain, mesh_of(domain, {{-36 - 2 * shift, -36, -36}, {36 + shift, 36, 36}})))
        << shift;
}

/// How a corner of a structured tetrahedron moves, by a distance in steps.
struct Move {
  std::size_t direction = 0;
  std::int32_t distance = 0;

  [[nodiscard]] Coord3 from(Coord3 vertex) const {
    return steps * vertex + distance * direction_offset[direction];
  }
};
using Moves = std::array<Move, 4>;

std::int64_t six_volume_after(const StructuredTet& tet, const Moves& moves) {
  std::array<Coord3, 4> corner;
  for (std::size_t n = 0; n < 4; ++n) corner[n] = moves[n].from(tet.vertices[n]);
  return six_volume(corner[0], corner[1], corner[2], corner[3]);
}

/// All fourfold directions in which no corner moves towards another one, by just
/// less than the thresholds of `angles`.
template <class Visit>
void for_each_moves(const StructuredTet& tet, Visit visit) {
  for (std::size_t code = 0; code < 14 * 14 * 14 * 14; ++code) {
    Moves moves;
    std::size_t rest = code;
    bool leaves = true;
    for (std::size_t n = 0; n < 4; ++n, rest /= 14) {
      const std::size_t d = rest % 14;
      moves[n] = {d, angle_thresholds.in_steps(static_cast<int>(d)) - 1};
      leaves = leaves && std::ranges::find(tet.vertices, tet.vertices[n] + direction_offset[d]) ==
                             tet.vertices.end();
    }
    if (leaves && !visit(moves)) return;
  }
}

Moves most_inverting_moves(const StructuredTet& tet) {
  Moves best{};
  std::int64_t least = 0;
  for_each_moves(tet, [&](const Moves& moves) {
    const std::int64_t v = six_volume_after(tet, moves);
    if (v < least) best = moves;
    least = std::min(v, least);
    return true;
  });
  EXPECT_LT(least, 0) << "these thresholds invert nothing: the test shows nothing";
  return best;
}

/// Makes the last move such that the volume, which is linear in its distance,
/// is nothing; false if no whole distance within the threshold does so.
bool flatten(const StructuredTet& tet, Moves& moves) {
  const std::int32_t limit = moves[3].distance;
  moves[3].distance = 0;
  const std::int64_t without = six_volume_after(tet, moves);
  moves[3].distance = 1;
  const std::int64_t slope = six_volume_after(tet, moves) - without;
  if (slope == 0 || without % slope != 0) return false;
  const std::int64_t distance = -without / slope;
  if (distance <= 0 || distance > limit) return false;
  moves[3].distance = static_cast<std::int32_t>(distance);
  return six_volume_after(tet, moves) == 0;
}

Moves flattening_moves(const StructuredTet& tet) {
  constexpr std::int32_t coarse = 1024;
  Moves found{};
  for_each_moves(tet, [&](const Moves& moves) {
    Moves flat = moves;
    for (std::size_t n = 0; n < 3; ++n) flat[n].distance -= flat[n].distance % coarse;
    if (flatten(tet, flat)) found = flat;
    return found[3].distance == 0;
  });
  EXPECT_GT(found[3].distance, 0) << "nothing flattens it: the test shows nothing";
  return found;
}

/// Inside everywhere but around the neighbours that the moves lead to; there,
/// the surface is where the corner moves to.
Sign sign_around(const StructuredTet& tet, const Moves& moves, Coord3 p) {
  for (std::size_t n = 0; n < 4; ++n) {
    const Coord3 e = direction_offset[moves[n].direction];
    const Coord3 from = p - steps * tet.vertices[n];
    const std::int32_t t = e.x != 0 ? from.x / e.x : e.y != 0 ? from.y / e.y : from.z / e.z;
    if (t >= 0 && t <= steps && from == t * e)
      return t < moves[n].distance ? Sign::plus : t == moves[n].distance ? Sign::on_surface : Sign::minus;
  }
  for (std::size_t n = 0; n < 4; ++n) {
    const Coord3 from = p - steps * (tet.vertices[n] + direction_offset[moves[n].direction]);
    const double distance = std::hypot(from.x, from.y, from.z) / steps;
    if (distance < 0.8) return Sign::minus;
  }
  return Sign::plus;
}

std::uint64_t inverted_tets(const StructuredTet& tet, const Moves& moves, Method method) {
  const domains::Positional domain([&](Coord3 p) { return sign_around(tet, moves, p); });
  Context context;
  return Stuffing(domain, around_origin(8), method, context).inverted_tets();
}

/// A flat one is as bad as one turned over, in either orientation.  No vertex but
/// its corners moves, so that it is the only one.
TEST(Engine, AFlatZeroTetrahedronCountsAsInverted) {
  for (std::size_t c = 0; c < case_count; ++c) {
    const StructuredTet tet = structured_tet({{0, 0, 0}, static_cast<StructuredTetCase>(c)});
    const Moves moves = flattening_moves(tet);
    EXPECT_EQ(inverted_tets(tet, moves, Method::angles), 1u) << case_names[c];
    Moves less = moves;
    --less[3].distance;
    Moves more = moves;
    ++more[3].distance;
    EXPECT_EQ(inverted_tets(tet, less, Method::angles) + inverted_tets(tet, more, Method::angles), 1u)
        << case_names[c];
  }
}

TEST(Engine, AnInvertedZeroTetrahedronMakesItFallBack) {
  const StructuredTet tet = structured_tet({{0, 0, 0}, StructuredTetCase::I1});
  static_assert(right_handed(StructuredTetCase::I1));
  const Moves moves = most_inverting_moves(tet);
  const domains::Positional domain([&](Coord3 p) { return sign_around(tet, moves, p); });
  const Lattice lattice = around_origin(8);
  Context context;
  const Stuffing angles(domain, lattice, Method::angles, context);
  EXPECT_GE(angles.inverted_tets(), 1u);
  EXPECT_EQ(angles.method(), Method::embedding);
  const Stuffing embedding(domain, lattice, Method::embedding, context);
  EXPECT_EQ(embedding.inverted_tets(), 0u);
  EXPECT_TRUE(same(emit(angles, {}, context), emit(embedding, {}, context)));
}

ErrorCode code_of(const Lattice& lattice) {
  try {
    mesh_of(ball(4), lattice);
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "no error";
  return {};
}

TEST(Engine, ALatticeOutsideTheRangeIsRefused) {
  EXPECT_EQ(code_of({{-31'994, 0, 0}, {10, 10, 10}}), ErrorCode::too_large);
  EXPECT_EQ(code_of({{0, 31'980, 0}, {10, 10, 10}}), ErrorCode::too_large);
  EXPECT_EQ(code_of({{0, 0, 0}, {10, 10, 2'000'000'000}}), ErrorCode::too_large);
  EXPECT_EQ(code_of({{1, 0, 0}, {10, 10, 10}}), ErrorCode::bad_option);
  EXPECT_EQ(code_of({{0, 0, 0}, {1, 10, 10}}), ErrorCode::bad_option);
}

/// The largest lattice that fits is one cell or one unit short of refusal.
TEST(Engine, TheRangeEndsWhereItSays) {
  Context context;
  const auto nowhere = domains::Positional([](Coord3) { return Sign::minus; });
  constexpr Coord3 low{-anchor_limit, -anchor_limit, -anchor_limit};
  EXPECT_NO_THROW(Stuffing(nowhere, {low, {2, 2, 2}}, {}, context));
  constexpr std::int32_t last = anchor_limit - 6;
  EXPECT_NO_THROW(Stuffing(nowhere, {{last, last, last}, {2, 2, 2}}, {}, context));
  for (const auto axis : {&Coord3::x, &Coord3::y, &Coord3::z}) {
    Coord3 beyond = low;
    beyond.*axis -= 2;
    EXPECT_EQ(code_of({beyond, {2, 2, 2}}), ErrorCode::too_large);
    beyond = {last, last, last};
    beyond.*axis += 2;
    EXPECT_EQ(code_of({beyond, {2, 2, 2}}), ErrorCode::too_large);
    Coord3 uneven{0, 0, 0};
    uneven.*axis = 1;
    EXPECT_EQ(code_of({uneven, {4, 4, 4}}), ErrorCode::bad_option);
  }
}

TEST(Engine, NothingIsAssumedThatWasNotSaid) {
  EXPECT_EQ(Lattice{}.origin, (Coord3{0, 0, 0}));
  EXPECT_EQ(Lattice{}.cells, (std::array<std::int32_t, 3>{0, 0, 0}));
  EXPECT_EQ(Method{}, Method::embedded);
  EXPECT_EQ(default_method, Method::key);
}

TEST(Engine, WithMidpointCutsTheSurfaceCountsAsInside) {
  const auto noise = domains::noise(3, 64);
  const domains::Positional rounded([&](Coord3 p) {
    return noise.sign_at(p) == Sign::minus ? Sign::minus : Sign::plus;
  });
  EXPECT_TRUE(same(mesh_of(noise, around_origin(8), 1, Method::midpoint),
                   mesh_of(rounded, around_origin(8), 1, Method::midpoint)));
  EXPECT_FALSE(same(mesh_of(noise, around_origin(8)), mesh_of(rounded, around_origin(8))));
}

TEST(Engine, AnEmptyDomainIsAnError) {
  const auto nowhere = domains::Positional([](Coord3) { return Sign::minus; });
  Context context;
  EXPECT_EQ(Stuffing(nowhere, around_origin(4), {}, context).tet_count(), 0u);
  EXPECT_THROW(stuff(nowhere, around_origin(4), {}, {}, context), Error);
}

TEST(Engine, ItStopsWhereverItIsCancelled) {
  const auto domain = ball(20);
  for (const Stage stage : {Stage::sample, Stage::cut, Stage::warp, Stage::count, Stage::emit}) {
    Context context;
    context.threads = 2;
    context.progress = [&](Stage now, std::int64_t, std::int64_t) {
      if (now == stage) context.cancelled = true;
    };
    try {
      stuff(domain, around_origin(16), {}, {}, context);
      ADD_FAILURE() << "not cancelled in stage " << name(stage);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::cancelled);
    }
  }
}

TEST(Engine, ProgressIsReportedStageByStage) {
  Context context;
  std::vector<Stage> order;
  std::int64_t expected = 0;
  context.progress = [&](Stage stage, std::int64_t done, std::int64_t total) {
    EXPECT_LE(done, total);
    if (done == 0) expected = 0;
    EXPECT_EQ(done, expected++) << name(stage);
    if (order.empty() || order.back() != stage) order.push_back(stage);
  };
  stuff(ball(10), around_origin(8), {}, {}, context);
  EXPECT_EQ(order, (std::vector{Stage::sample, Stage::cut, Stage::warp, Stage::count, Stage::emit}));
}

#ifdef CERTET_THREAD_SANITIZER
/// The thread sanitizer is there and looks: tasks that count in one place are seen.
TEST(EngineDeathTest, ARaceBetweenTasksIsSeen) {
  EXPECT_DEATH(
      {
        Context context;
        context.threads = 4;
        std::int64_t counted = 0;
        core::parallel_for(context, Stage::sample, 100'000, [&](std::int64_t) { ++counted; });
      },
      "data race");
}
#endif

}  // namespace
}  // namespace certet
