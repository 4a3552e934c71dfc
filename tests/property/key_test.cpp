/// \file
/// Where violated vertices settle and diagonals follow the cuts: each mesh is that of the plain
/// rule, has the shape of the samples and no overlaps, and angles as proved.

#include <gtest/gtest.h>

#include <algorithm>

#include "settling_fields.hpp"
#include "soak/thin/overlap.hpp"

namespace {

using namespace settling;
using settling::Tets;
using diagonals::Choice;

/// Fields of several kinds, so many of each: those of the other rule, with cuts at the thresholds
/// of this one, at few places, so that many are equal, and in the middle.
std::vector<Positional> key_fields(std::uint64_t seed, int each) {
  std::vector<Positional> all = fields(seed, each);
  for (int n = 0; n < each; ++n) {
    const std::uint64_t own = mixed(seed, 1000 + n);
    all.push_back(domains::random_cuts(own, 0, {0, 1, 16383, 16384, 24319, 24320, 41216, 49152, 65535}));
    all.push_back(domains::random_cuts(own, 40, {16384, 24320, 32768, 41216, 49152}));
    all.push_back(domains::random_cuts(own, 0, {32767, 32768, 32769}));
  }
  return all;
}

std::string overlap_fault(const Tets& mesh) {
  std::vector<exact::Tet> tets;
  for (const auto& [a, b, c, d] : mesh.tets)
    tets.push_back({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]});
  return thin::overlaps(tets).found == 0 ? "" : "tetrahedra overlap";
}

/// Whatever is wrong with a mesh.
std::string key_fault(const Model& model, const Tets& mesh) {
  const std::string what = fault(model, mesh, exact::key_range);
  return what.empty() ? overlap_fault(mesh) : what;
}

/// Each of them exactly as the model says, and without a fault; no move is shortened.
TEST(Key, KeepsTheShapeOfRandomFields) {
  std::uint64_t stayed = 0;
  for (int batch = 0; batch < 4; ++batch)
    for (const Positional& field : key_fields(mixed(test_seed(), batch), 25)) {
      Model model(field, small, key_rule());
      WarpFigures figures;
      const Tets made = engine_mesh(field, small, Method::key, figures);
      ASSERT_EQ(difference(model, made, figures), "");
      ASSERT_EQ(key_fault(model, made), "");
      ASSERT_EQ(figures.shortened, 0u);
      stayed += figures.stayed;
    }
  EXPECT_GT(stayed, 5000u);
}

/// The meshes of some fields by the plain rule with a defect: how many have this fault.
int wrong_meshes(Choice choice, const std::string& how) {
  return wrong_meshes(key_fields(test_seed(), 4), small, key_rule(choice), how, exact::key_range);
}

/// In how many meshes a defect of the rule is seen beside the engine's.
int other_meshes(Choice choice) {
  int other = 0;
  for (const Positional& field : key_fields(test_seed(), 4)) {
    WarpFigures figures;
    other += positions(engine_mesh(field, small, Method::key, figures)) !=
             positions(Model(field, small, key_rule(choice)).mesh());
  }
  return other;
}

TEST(Key, CatchesNothingWithoutADefect) { EXPECT_EQ(other_meshes(Choice::lesser), 0); }

TEST(Key, CatchesDiagonalsAtTheGreaterCut) {
  EXPECT_GT(wrong_meshes(Choice::greater, "an angle is out of range"), 0);
  EXPECT_GT(other_meshes(Choice::greater), 0);
}

TEST(Key, CatchesCutsFromTheMinusEnd) {
  EXPECT_GT(wrong_meshes(Choice::from_minus, "an angle is out of range"), 0);
  EXPECT_GT(other_meshes(Choice::from_minus), 0);
}

/// Which of two equal cuts comes first is no matter of angles.
TEST(Key, CatchesTiesTheOtherWay) { EXPECT_GT(other_meshes(Choice::other_ties), 0); }

TEST(Key, CatchesTheParityRule) {
  EXPECT_GT(wrong_meshes(Choice::parity, "an angle is out of range"), 0);
  EXPECT_GT(other_meshes(Choice::parity), 0);
}

}  // namespace
