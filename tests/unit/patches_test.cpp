// Patches of the boundary: the sides of a box, and those that users name.

#include "certet/patches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include "certet/bounded_function.hpp"
#include "certet/error.hpp"
#include "engine/border.hpp"
#include "seed.hpp"

namespace certet {
namespace {

constexpr std::size_t first_side = static_cast<std::size_t>(Patch::xmin);

/// A box of which all is inside, cut off on all sides.
auto whole(const Bounds& bounds, double size) {
  return BoundedFunction([](Point3) { return -1.0; }, bounds, size);
}

/// A ball of radius 1 that is cut off below, at z = -0.5.
auto cut_ball() {
  return BoundedFunction([](Point3 p) { return std::hypot(p[0], p[1], p[2]) - 1; },
                         Bounds{{-2, -2, -0.5}, {2, 2, 2}}, 0.2);
}

/// The side that most corners of a face are at, of several the first, by plain arithmetic.
std::size_t side_by_places(const std::array<Point3, 3>& corners, const Bounds& bounds, double near) {
  std::array<int, 6> votes{};
  for (const Point3& p : corners)
    for (std::size_t a = 0; a < 3; ++a) {
      votes[2 * a] += std::abs(p[a] - bounds.low[a]) <= near ? 1 : 0;
      votes[2 * a + 1] += std::abs(p[a] - bounds.high[a]) <= near ? 1 : 0;
    }
  return static_cast<std::size_t>(std::ranges::max_element(votes) - votes.begin());
}

std::map<std::string, PatchFigures> figures_of(const Mesh& mesh) {
  Context context;
  const Survey found = survey(mesh, context);
  const Buffer<Point3> world = world_points(mesh);
  std::map<std::string, PatchFigures> figures;
  for (const PatchFigures& one : patch_figures(found, [&](std::uint64_t p) { return world[p]; }))
    figures.emplace(one.name, one);
  return figures;
}

std::string refusal_of(Mesh& mesh, const std::vector<PatchChoice>& choices) {
  mesh.patches = choices;
  Context context;
  try {
    static_cast<void>(survey(mesh, context));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_option);
    return error.what();
  }
  return "";
}

TEST(Sides, AreCalledAfterTheAxesOfTheWorld) {
  // x of the lattice is y of the world, and y is -x.
  const Frame frame{{1, 2, 3}, {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}, 0.5};
  const auto world = [&](double x, double y, double z) { return frame.world_at({x, y, z}); };
  const Point3 corner = world(-3, -4, -5), opposite = world(3, 4, 5);
  for (const BorderBox& box : {BorderBox::along_frame(frame, corner, opposite),
                               BorderBox::along_world(frame, corner, opposite)}) {
    const std::array<BorderBox, 1> boxes{box};
    const core::BorderSides sides(boxes, Cuts::bisect, frame);
    EXPECT_EQ(sides.at({-3 * steps, 0, 0}), 1 << 2);  // ymin
    EXPECT_EQ(sides.at({3 * steps, 0, 0}), 1 << 3);
    EXPECT_EQ(sides.at({0, 4 * steps, 0}), 1 << 0);  // xmin
    EXPECT_EQ(sides.at({0, -4 * steps, 5 * steps}), 1 << 1 | 1 << 5);
    EXPECT_EQ(sides.at({0, 0, 0}), 0);
  }
}

/// All rotations that permute axes, and small turns of them, keep the names of the nearest axes;
/// of a half of a right angle the first way is taken.
TEST(Sides, OfTurnedBoxesAreThoseOfTheNearestAxes) {
  std::array<std::size_t, 3> way{0, 1, 2};
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      Frame frame;
      for (std::size_t a = 0; a < 3; ++a) {
        frame.axes[0][a] = frame.axes[1][a] = frame.axes[2][a] = 0;
        frame.axes[way[a]][a] = (signs >> a & 1) != 0 ? -1 : 1;
      }
      const BorderBox box = BorderBox::along_frame(frame, {-1, -1, -1}, {1, 1, 1});
      Frame turned = frame;
      for (std::size_t a = 0; a < 3; ++a) {
        const double x = frame.axes[0][a], y = frame.axes[1][a];
        turned.axes[0][a] = 0.8 * x - 0.6 * y;
        turned.axes[1][a] = 0.6 * x + 0.8 * y;
      }
      for (std::size_t a = 0; a < 3; ++a) {
        const bool back = (signs >> a & 1) != 0;
        for (const Frame& seen : {frame, turned}) {
          EXPECT_EQ(box.world_sides(seen)[2 * a], 2 * way[a] + (back ? 1 : 0));
          EXPECT_EQ(box.world_sides(seen)[2 * a + 1], 2 * way[a] + (back ? 0 : 1));
        }
      }
    }
  } while (std::ranges::next_permutation(way).found);
  const double half = std::sqrt(0.5);
  const Frame between{{}, {{{half, -half, 0}, {half, half, 0}, {0, 0, 1}}}, 1};
  const BorderBox box = BorderBox::along_frame(between, {-1, -1, -1}, {1, 1, 1});
  EXPECT_EQ(box.world_sides(between), (std::array<std::uint8_t, 6>{0, 1, 2, 3, 4, 5}));
}

TEST(Sides, AFaceHasThatOfMostCornersOrElseTheFirst) {
  EXPECT_EQ(core::side_of_face({Sides{8}, Sides{8}, Sides{8}}), 3U);
  EXPECT_EQ(core::side_of_face({Sides{1}, Sides{8}, Sides{8}}), 3U);
  EXPECT_EQ(core::side_of_face({Sides{32}, Sides{8}, Sides{1}}), 0U);
  EXPECT_EQ(core::side_of_face({Sides{1 | 16}, Sides{16}, Sides{1}}), 0U);
  EXPECT_EQ(core::side_of_face({Sides{1 | 16}, Sides{16}, Sides{0}}), 4U);
}

/// Of random boxes by all methods, face by face; the areas are about those of the box.
TEST(Sides, OfABoxAreWhereItsPlanesAre) {
  std::mt19937_64 random(test_seed());
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  for (const MethodFacts& method : methods) {
    Bounds bounds{{-1, -1.5, -2}, {1.2, 1.5, 1}};
    for (std::size_t a = 0; a < 3; ++a) bounds.low[a] += shift(random), bounds.high[a] += shift(random);
    const auto domain = whole(bounds, 0.2);
    Context context;
    const Mesh made = mesh(domain, method.method, context);
    const Survey found = survey(made, context);
    const Stuffing stuffing(domain, domain.lattice(), method.method, context);
    EXPECT_EQ(survey(stuffing, context, domain.frame()).boundary, found.boundary);
    const Buffer<Point3> world = world_points(made);
    std::array<double, 6> along{};
    std::uint64_t wrong = 0, if_turned = 0, cut_off = 0;
    for (const BoundaryFace& face : found.boundary) {
      const auto& [a, b, c] = face.points;
      const std::array<Point3, 3> corners{world[a], world[b], world[c]};
      if (!face.is_cut_off) continue;
      ++cut_off;
      const std::size_t side = static_cast<std::size_t>(face.patch) - first_side;
      ASSERT_LT(side, 6U);
      const std::size_t x = (side / 2 + 1) % 3, y = (side / 2 + 2) % 3;
      along[side] += ((corners[1][x] - corners[0][x]) * (corners[2][y] - corners[0][y]) -
                      (corners[1][y] - corners[0][y]) * (corners[2][x] - corners[0][x])) / 2;
      if (method.cuts != Cuts::bisect) continue;
      const std::size_t expected = side_by_places(corners, bounds, 1e-4);
      wrong += side != expected ? 1 : 0;
      if_turned += (side ^ 1) != expected ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0U);
    EXPECT_GT(cut_off, found.boundary.size() * 9 / 10) << name(method.method);
    if (method.cuts == Cuts::bisect) {
      EXPECT_EQ(if_turned, cut_off);
    }
    for (std::size_t side = 0; side < 6; ++side) {
      const std::size_t x = (side / 2 + 1) % 3, y = (side / 2 + 2) % 3;
      const double area = (bounds.high[x] - bounds.low[x]) * (bounds.high[y] - bounds.low[y]);
      EXPECT_NEAR(side % 2 == 0 ? -along[side] : along[side], area, 0.3 * area)
          << name(method.method) << ", side " << side;
    }
  }
}

TEST(NamedPatches, AreThosePlanesAndSidesThatAreNamed) {
  Mesh made = mesh(cut_ball());
  const auto before = figures_of(made);
  ASSERT_EQ(before.size(), 2U);
  // Without the triangles along the rim, which have a corner on the ball.
  EXPECT_NEAR(before.at("zmin").area, 0.65 * 3.14159265, 0.12 * 3.14159265);
  made.patches = {patch_choice("floor", "zmin")};
  auto named = figures_of(made);
  EXPECT_EQ(named.at("floor").triangles, before.at("zmin").triangles);
  EXPECT_EQ(named.at("floor").area, before.at("zmin").area);
  EXPECT_EQ(named.count("zmin"), 0U);
  made.patches.push_back(patch_choice("top", "z:1"));
  named = figures_of(made);
  EXPECT_EQ(named.size(), 3U);
  // The cap within half an edge of the top: 2 pi h, at most.
  EXPECT_GT(named.at("top").area, 0.2);
  EXPECT_LT(named.at("top").area, 0.2 * 3.15);
  EXPECT_EQ(named.at("top").triangles + named.at("surface").triangles,
            before.at("surface").triangles);
  // The last one has what several would.
  made.patches = {patch_choice("wall", "surface"), patch_choice("top", "z:1")};
  EXPECT_EQ(figures_of(made).at("top").triangles, named.at("top").triangles);
  EXPECT_EQ(figures_of(made).at("wall").triangles, named.at("surface").triangles);
}

/// What lies at a plane leans by at most 60 degrees: a wall that begins there is not in it.
TEST(NamedPatches, OfAPlaneHaveNoWalls) {
  const Bounds bounds{{-1, -1, -1}, {1, 1, 1}};
  Mesh made = mesh(whole(bounds, 0.5));
  made.patches = {patch_choice("lid", "z:1")};
  Context context;
  const Survey found = survey(made, context);
  const Buffer<Point3> world = world_points(made);
  std::uint64_t faces = 0;
  for (const BoundaryFace& face : found.boundary) {
    if (face.patch != static_cast<Patch>(patch_names.size())) continue;
    ++faces;
    for (const std::uint64_t p : face.points) EXPECT_NEAR(world[p][2], 1, 0.25);
  }
  EXPECT_GT(faces, 16U);
  EXPECT_NEAR(figures_of(made).at("lid").area, 4, 0.8);
}

TEST(NamedPatches, AreRefusedInASentence) {
  Mesh made = mesh(cut_ball());
  const auto expect_words = [](const std::string& sentence, const std::string& words) {
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  };
  expect_words(refusal_of(made, {patch_choice("a", "xmin")}), "has no patch 'xmin'");
  expect_words(refusal_of(made, {patch_choice("a", "z:3")}), "lies within 0.1 of z:3");
  expect_words(refusal_of(made, {patch_choice("a", "zmin"), patch_choice("A", "surface")}),
               "two patches are named 'A'");
  expect_words(refusal_of(made, {patch_choice("a", "zmin"), patch_choice("b", "zmin")}),
               "'a' are in others");
  EXPECT_EQ(refusal_of(made, {patch_choice("a", "zmin"), patch_choice("b", "surface")}), "");
  for (const auto& [name, where] :
       {std::pair("", "zmin"), std::pair("1a", "zmin"), std::pair("a b", "zmin"),
        std::pair("surface", "zmin"), std::pair("xMin", "zmin"), std::pair("a", "w:1"),
        std::pair("a", "z:"), std::pair("a", "z:nan"), std::pair("a", "z:1,2"), std::pair("a", "bottom")})
    EXPECT_THROW(patch_choice(name, where), Error) << name << '=' << where;
}

TEST(NamedPatches, AreWhatTheirWordsSay) {
  for (const char* where : {"surface", "border", "zmax", "x:-0.1", "y:1e-30", "z:12.5"})
    EXPECT_EQ(patch_choice("a", text_of(patch_choice("a", where).where)), patch_choice("a", where));
}

}  // namespace
}  // namespace certet
