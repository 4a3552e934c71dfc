/// \file
/// The stages over windows: the same layers meshed window by window, each with
/// its halo, are the mesh of the whole.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <numeric>
#include <set>
#include <vector>

#include "certet/stuffing.hpp"
#include "engine/emit.hpp"
#include "engine/sample.hpp"
#include "engine/settle.hpp"
#include "engine/window.hpp"
#include "domains.hpp"
#include "materials.hpp"

namespace {

using namespace certet;

struct Made {
  std::vector<Coord3> points;
  std::vector<std::uint8_t> on_surface;
  std::vector<Tet<std::uint32_t>> tets;
  std::vector<Material> materials;  ///< where several are cut apart
  std::uint64_t inverted = 0;
  WarpFigures figures;
  friend bool operator==(const Made&, const Made&) = default;
};

/// How many layers more a method looks at.
std::int32_t halo_of(const MethodFacts& method) {
  return method.settles ? core::settling_halo : 0;
}

const MethodFacts& random_method() {
  return facts((*rc::gen::elementOf(methods)).method);
}

/// The warped lattice of one window; `signs` is where it is sampled, `halo` the method's, or less.
core::WarpedLattice warped_of(const Domain& domain, const Lattice& lattice, core::Window window,
                              core::Window signs, std::int32_t halo, const MethodFacts& method,
                              Made& made) {
  Context context;
  context.threads = 1;
  core::SignPlanes planes = core::sample(domain, lattice, signs, method, context);
  const auto cuts_of = [&](core::Window cut) {
    return core::find_cuts(planes, domain, lattice, cut, method.cuts, context);
  };
  if (method.cuts == Cuts::midpoint)
    return core::unwarped(std::move(planes), cuts_of(window), window);
  const auto cuts = cuts_of(core::cut_window(window, lattice, halo));
  core::Violations violations = core::find_violations(
      planes, cuts, core::violation_window(window, lattice, halo), method.thresholds, context);
  core::Settling settled = method.settles
                               ? core::settle(planes, violations, method.thresholds, lattice, window, context)
                               : core::Settling{core::move_all(planes, violations, context)};
  if (!method.settles)
    made.inverted += core::inverted_tets(settled.planes, violations, lattice, window, context);
  made.figures.add(settled.figures);
  core::WarpedLattice warped = core::warp_lattice(
      {planes, std::move(settled.planes)}, violations, cuts,
      method.settles ? method.thresholds : no_warp_thresholds, lattice, window, context);
  warped.diagonals_follow_cuts = method.diagonals_follow_cuts;
  return warped;
}

/// Adds the mesh of one window, as `warped_of` has it.
void add_window(const Domain& domain, const Lattice& lattice, core::Window window,
                core::Window signs, std::int32_t halo, const MethodFacts& method, Made& made) {
  Context context;
  context.threads = 1;
  const core::WarpedLattice warped =
      warped_of(domain, lattice, window, signs, halo, method, made);
  made.figures.add(warped.figures);
  core::RowNumbers numbers(warped.planes, lattice, window, context);
  const std::size_t points = made.points.size();
  const std::size_t tets = made.tets.size();
  numbers.start_from(points, tets);
  made.points.resize(points + numbers.point_count());
  made.on_surface.resize(points + numbers.point_count());
  made.tets.resize(tets + numbers.tet_count());
  core::emit_points(warped, numbers, lattice, window, std::span(made.points).subspan(points),
                    context);
  core::mark_surface(warped, numbers, lattice, window,
                     std::span(made.on_surface).subspan(points), context);
  core::emit_tets(warped, numbers, lattice, window, std::span(made.tets).subspan(tets), context);
  if (warped.planes.materials() == nullptr) return;
  made.materials.resize(made.tets.size());
  core::emit_materials(warped.planes, numbers, lattice, window,
                       std::span(made.materials).subspan(tets), context);
}

Made in_windows(const Domain& domain, const Lattice& lattice, const std::vector<int>& bounds,
                const MethodFacts& method) {
  Made made;
  for (std::size_t n = 0; n + 1 < bounds.size(); ++n) {
    const core::Window window{bounds[n], bounds[n + 1]};
    add_window(domain, lattice, window, core::sampled_window(window, lattice, halo_of(method)),
               halo_of(method), method, made);
  }
  return made;
}

/// A lattice of at least five layers, and of many where the method looks far; some rows
/// are longer than a word.
Lattice random_lattice(const MethodFacts& method) {
  const auto cells = [](int low, int high) { return *rc::gen::inRange(low, high + 1); };
  Lattice lattice;
  lattice.cells = {*rc::gen::element(3, 6, 66), cells(3, 7),
                   cells(5, halo_of(method) == 0 ? 24 : 96)};
  lattice.origin = {-lattice.cells[0] / 2 * 2, 0, 2 * cells(-20, 20)};
  return lattice;
}

/// Full of surface, so that every layer depends on those around it.
domains::Positional random_domain() {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  if (*rc::gen::arbitrary<bool>()) return domains::noise(seed, 20);
  return domains::random_cuts(seed, 20, {0, 1, 12000, 20000, 32768, 50000, 65535});
}

/// Where the windows end: 0, some layers, and the last.
std::vector<int> random_bounds(int layers) {
  const auto inner = *rc::gen::container<std::set<int>>(rc::gen::inRange(1, layers));
  std::vector<int> bounds{0};
  bounds.insert(bounds.end(), inner.begin(), inner.end());
  bounds.push_back(layers);
  return bounds;
}

/// What make(domain, lattice, bounds, method) makes of windows is what it makes of one, which
/// is given back.
template <class Make>
auto windows_make_the_whole(const MethodFacts& method, const Domain& domain, const Make& make) {
  const Lattice lattice = random_lattice(method);
  const auto layers = lattice.cells[2];
  auto whole = make(domain, lattice, std::vector<int>{0, layers}, method);
  RC_ASSERT(make(domain, lattice, random_bounds(layers), method) == whole);
  return whole;
}

RC_GTEST_PROP(Window, WindowsMakeTheWhole, ()) {
  const MethodFacts& method = random_method();
  windows_make_the_whole(method, random_domain(), in_windows);
}

constexpr Lattice twelve_layers{{0, 0, 0}, {9, 9, 12}};

/// Where windows end, if each is of one layer.
std::vector<int> of_each_layer(const Lattice& lattice) {
  std::vector<int> bounds(static_cast<std::size_t>(lattice.cells[2]) + 1);
  std::iota(bounds.begin(), bounds.end(), 0);
  return bounds;
}

TEST(Window, OneLayerAtATime) {
  const auto domain = domains::of_level(domains::gyroid(11, 0.8));
  const std::vector<int> bounds = of_each_layer(twelve_layers);
  for (const Method one : {Method::embedded, Method::embedding}) {
    const MethodFacts& method = facts(one);
    const Made whole = in_windows(domain, twelve_layers, {0, 12}, method);
    EXPECT_GT(whole.tets.size(), 500u);
    EXPECT_EQ(in_windows(domain, twelve_layers, bounds, method), whole);
  }
}

/// A window's last odd points look at even ones a layer behind it.
TEST(Window, CubesArePartedAcrossWindows) {
  const auto noise = domains::noise(5, 0);
  const domains::Parted parted([&](Coord3 p) { return noise.sign_at(p); });
  const std::vector<int> bounds = of_each_layer(twelve_layers);
  const MethodFacts& method = facts(Method::embedded);
  const Made whole = in_windows(parted, twelve_layers, {0, 12}, method);
  EXPECT_EQ(in_windows(parted, twelve_layers, bounds, method), whole);
  EXPECT_NE(in_windows(noise, twelve_layers, {0, 12}, method), whole);
  const MethodFacts& paper = facts(Method::embedding);
  EXPECT_EQ(in_windows(parted, twelve_layers, bounds, paper), in_windows(noise, twelve_layers, bounds, paper));
}

/// What `Stuffing` makes is what the stages make of the whole.
TEST(Window, TheWholeIsTheEnginesMesh) {
  const auto domain = domains::of_level(domains::gyroid(11, 0.8));
  Context context;
  for (const Method method : {Method::embedded, Method::embedding}) {
    const Stuffing stuffing(domain, twelve_layers, method, context);
    const Mesh mesh = emit(stuffing, {}, context);
    const Made made = in_windows(domain, twelve_layers, {0, 12}, facts(method));
    EXPECT_TRUE(std::ranges::equal(mesh.points, made.points));
    EXPECT_TRUE(std::ranges::equal(std::get<0>(mesh.tets), made.tets));
    if (facts(method).settles) {
      EXPECT_EQ(stuffing.warp_figures(), made.figures);
    }
  }
}

materials::Positional random_materials() {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  return materials::cubes(seed, *rc::gen::element(1, 2, 5), {1, 2, 3, 8}, 70);
}

/// Where materials are cut apart, each window has its part of every interface.
RC_GTEST_PROP(Window, WindowsOfMaterialsMakeTheWhole, ()) {
  const MethodFacts& method = facts(*rc::gen::element(Method::embedded, Method::midpoint));
  const Made whole = windows_make_the_whole(method, random_materials(), in_windows);
  RC_ASSERT(whole.materials.size() == whole.tets.size());
}

/// A method by which the domain is asked for the materials.
const MethodFacts& random_uncut_method() {
  return facts(*rc::gen::element(Method::angles, Method::embedding));
}

/// Materials of the tetrahedra of windows, one after the other.  `behind` is how many
/// layers of points behind its own each window asks its neighbour for.
std::vector<Material> materials_in_windows(const Domain& domain, const Lattice& lattice,
                                           const std::vector<int>& bounds,
                                           const MethodFacts& method, int behind) {
  Context context;
  context.threads = 1;
  std::vector<Material> all;
  for (std::size_t n = 0; n + 1 < bounds.size(); ++n) {
    const core::Window window{bounds[n], bounds[n + 1]};
    const core::Window reached = core::widened(window, 0, behind, lattice);
    Made made;
    const core::WarpedLattice warped =
        warped_of(domain, lattice, reached,
                  core::sampled_window(reached, lattice, halo_of(method)), halo_of(method), method,
                  made);
    const core::RowNumbers numbers(warped.planes, lattice, reached, context);
    std::vector<Coord3> points(numbers.point_count());
    core::emit_points(warped, numbers, lattice, reached, std::span(points), context);
    const std::uint64_t count =
        numbers.first_tet(0, window.end) - numbers.first_tet(0, window.begin);
    std::vector<Tet<std::uint32_t>> tets(count);
    core::emit_tets(warped, numbers, lattice, window, std::span(tets), context);
    const std::size_t before = all.size();
    all.resize(before + count);
    core::emit_materials(domain, numbers, lattice, window, points,
                         std::span<const Tet<std::uint32_t>>(tets),
                         std::span(all).subspan(before), context);
  }
  return all;
}

/// With the layer of points behind each, windows have the materials of the whole.
RC_GTEST_PROP(Window, MaterialsOfWindowsAreThoseOfTheWhole, ()) {
  const MethodFacts& method = random_uncut_method();
  windows_make_the_whole(method, random_materials(), [](const auto&... those) {
    return materials_in_windows(those..., 1);
  });
}

/// They are the whole mesh's, tetrahedron by tetrahedron, and do depend on where the
/// corners are: those of the tetrahedron before would be other ones.
TEST(Window, MaterialsAreThoseOfTheCorners) {
  const auto domain = materials::cubes(3, 2, {1, 2, 3}, 60);
  const MethodFacts& method = facts(Method::embedding);
  const Made made = in_windows(domain, twelve_layers, {0, 12}, method);
  const auto found = materials_in_windows(domain, twelve_layers, {0, 5, 6, 12}, method, 1);
  ASSERT_EQ(found.size(), made.tets.size());
  const auto differences = [&](std::size_t shift) {
    std::size_t count = 0;
    for (std::size_t t = shift; t < found.size(); ++t) {
      TetCorners corners;
      for (std::size_t v = 0; v < 4; ++v) corners[v] = made.points[made.tets[t - shift][v]];
      Material material = 0;
      domain.materials_of({&corners, 1}, {&material, 1});
      count += material != found[t];
    }
    return count;
  };
  EXPECT_EQ(differences(0), 0u);
  EXPECT_GT(differences(1), 0u);
}

/// Without the layer behind there is no room for its points, which is said.
TEST(Window, MaterialsNeedTheLayerBehind) {
  const auto domain = materials::cubes(3, 2, {1, 2, 3}, 60);
  const MethodFacts& method = facts(Method::embedding);
  EXPECT_NO_THROW(materials_in_windows(domain, twelve_layers, {4, 6}, method, 1));
  EXPECT_THROW(materials_in_windows(domain, twelve_layers, {4, 6}, method, 0), Error);
  // The last layer has none behind it.
  EXPECT_NO_THROW(materials_in_windows(domain, twelve_layers, {4, 12}, method, 0));
}

/// A window with a layer less on either side makes another mesh of some domains.
TEST(Window, NoLayerAroundIsIdle) {
  const Lattice lattice{{0, 0, 0}, {12, 12, 16}};
  const core::Window window{6, 8};
  const core::Window needed = core::sampled_window(window, lattice, 0);
  const MethodFacts& method = facts(Method::angles);
  const auto differs = [&](core::Window signs) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const auto domain = domains::random_cuts(seed, 0, {1000, 30000, 64000});
      Made right;
      Made wrong;
      add_window(domain, lattice, window, needed, 0, method, right);
      add_window(domain, lattice, window, signs, 0, method, wrong);
      if (wrong != right) return true;
    }
    return false;
  };
  EXPECT_FALSE(differs(needed));
  EXPECT_TRUE(differs({needed.begin + 1, needed.end}));
  EXPECT_TRUE(differs({needed.begin, needed.end - 1}));
}

/// Vertices that settle look farther than those that just move: by chance a few layers, and
/// at most one for each turn.
TEST(Window, SettlingNeedsAHalo) {
  const Lattice lattice{{0, 0, 0}, {8, 8, 80}};
  const core::Window window{39, 41};
  const auto with_halo = [&](const Domain& domain, std::int32_t halo) {
    Made made;
    add_window(domain, lattice, window, core::sampled_window(window, lattice, halo), halo,
               facts(Method::embedded),
               made);
    return made;
  };
  int needed = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const auto domain = domains::random_cuts(seed, 0, {100, 7000, 15000, 24000, 40000, 65000});
    const Made right = with_halo(domain, core::settling_halo);
    EXPECT_EQ(with_halo(domain, core::settling_halo + 5), right);
    for (int halo = needed; halo < 4; ++halo)
      if (with_halo(domain, halo) != right) needed = halo + 1;
  }
  EXPECT_GE(needed, 2);
}

TEST(Window, RoomIsChecked) {
  const Lattice lattice{{0, 0, 0}, {8, 8, 8}};
  const auto domain = domains::of_level(domains::sphere(8, 8, 8, 5));
  Context context;
  const Stuffing stuffing(domain, lattice, {}, context);
  std::vector<Coord3> points(stuffing.point_count() + 1);
  std::vector<std::uint8_t> marks(stuffing.point_count() - 1);
  std::vector<Tet<std::uint32_t>> tets(stuffing.tet_count() - 1);
  EXPECT_THROW(stuffing.emit_points(0, 8, points, context), Error);
  EXPECT_THROW(stuffing.mark_surface(0, 8, marks, context), Error);
  EXPECT_THROW(stuffing.emit_tets(0, 8, tets, context), Error);
}

/// 32 bits are refused where they would wrap, and no earlier.
TEST(Window, WidthOfIndicesIsChecked) {
  const Lattice lattice{{0, 0, 0}, {8, 8, 8}};
  const auto domain = domains::of_level(domains::sphere(8, 8, 8, 5));
  Context context;
  const core::Window all = core::whole(lattice);
  const auto planes = core::sample(domain, lattice, all, facts(Method::midpoint), context);
  const auto warped = core::unwarped(
      planes, core::find_cuts(planes, domain, lattice, all, Cuts::midpoint, context), all);
  core::RowNumbers numbers(warped.planes, lattice, all, context);
  std::vector<Tet<std::uint32_t>> tets(numbers.tet_count());
  const std::uint64_t top = std::uint64_t{1} << 32;
  numbers.start_from(top - 1 - numbers.point_count(), 0);
  EXPECT_NO_THROW(core::emit_tets(warped, numbers, lattice, all, std::span(tets), context));
  numbers.start_from(top - numbers.point_count(), 0);
  EXPECT_THROW(core::emit_tets(warped, numbers, lattice, all, std::span(tets), context), Error);
}

}  // namespace
