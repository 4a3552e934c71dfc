/// \file
/// Warping: every pattern of neighbours with cuts on and beside the thresholds,
/// every pair of edges with every pair of such cuts, and random ones beyond.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>
#include <sstream>

#include "certified.hpp"
#include "differences.hpp"
#include "implementation.hpp"

namespace {

constexpr int count = certet::direction_count;
constexpr Sign all_signs[] = {Sign::minus, Sign::on_surface, Sign::plus};
constexpr Sign sides[] = {Sign::minus, Sign::plus};

struct Case {
  certet::Thresholds thresholds;
  Sign sign;
  NeighborSigns neighbor_sign;
  NeighborCuts cut;
};

std::string show(const Case& c) {
  std::ostringstream out;
  out << "thresholds " << c.thresholds.long_edge << ' ' << c.thresholds.short_edge << ", sign "
      << "-0+"[static_cast<int>(c.sign)] << ", neighbours";
  for (std::size_t d = 0; d < count; ++d)
    out << ' ' << "-0+"[static_cast<int>(c.neighbor_sign[d])] << c.cut[d];
  return out.str();
}

bool agree(const Implementation& production, const Case& c) {
  const certet::Warping ours =
      production.warp(c.thresholds, c.sign, c.neighbor_sign, c.cut);
  const certified::Warping theirs = certified::warp(
      {c.thresholds.long_edge, c.thresholds.short_edge}, c.sign,
      [&](int d) { return c.neighbor_sign[static_cast<std::size_t>(d)]; },
      [&](int d) { return c.cut[static_cast<std::size_t>(d)]; });
  return ours.direction == theirs.direction && ours.distance == theirs.distance;
}

constexpr certet::Thresholds all_thresholds[] = {
    certet::angle_thresholds, certet::embedding_thresholds, certet::no_warp_thresholds};

/// 0, one step below, on and above either threshold, the middle, the last two
/// steps; and for the short threshold the long cuts just nearer and farther
/// (there is no tie between a long and a short edge but at 0).
std::vector<std::int32_t> boundary_cuts(certet::Thresholds t) {
  const std::int32_t long_steps = t.in_steps(0);
  const std::int32_t short_steps = t.in_steps(6);
  std::set<std::int32_t> cuts{0, 1, certet::steps / 2, certet::steps - 1, certet::steps};
  for (const std::int32_t threshold : {long_steps, short_steps})
    for (const std::int32_t beside : {-1, 0, 1})
      if (threshold + beside >= 0) cuts.insert(threshold + beside);
  std::int64_t long_cut = 0;  // the last one not farther than short_cut on a short edge
  const std::int64_t short_cut = std::max(0, long_steps - 1);
  while (4 * (long_cut + 1) * (long_cut + 1) <= 3 * short_cut * short_cut) ++long_cut;
  cuts.insert(static_cast<std::int32_t>(long_cut));
  cuts.insert(static_cast<std::int32_t>(long_cut + 1));
  return {cuts.begin(), cuts.end()};
}

/// Every set of opposite neighbours, all of them cut at the same distance:
/// 2 * 2^14 * 4 cases.
Differences compare_patterns(const Implementation& production) {
  Differences differences;
  const certet::Thresholds t = certet::angle_thresholds;
  for (const std::int32_t cut : {0, t.in_steps(0) - 1, t.in_steps(0), t.in_steps(6)}) {
    Case c{t, Sign::plus, {}, {}};
    c.cut.fill(cut);
    for (const Sign sign : sides)
      for (unsigned opposite = 0; opposite < 1U << count; ++opposite) {
        c.sign = sign;
        for (std::size_t d = 0; d < count; ++d)
          c.neighbor_sign[d] =
              (opposite >> d & 1U) == ((sign == Sign::plus) ? 1U : 0U) ? Sign::minus : Sign::plus;
        differences.expect(agree(production, c), [&] { return show(c); });
      }
  }
  return differences;
}

/// Every pair of edges, every pair of boundary cuts on them, every threshold;
/// no other edge is cut.
Differences compare_pairs(const Implementation& production) {
  Differences differences;
  for (const certet::Thresholds t : all_thresholds) {
    const std::vector<std::int32_t> cuts = boundary_cuts(t);
    for (std::size_t d = 0; d < count; ++d)
      for (std::size_t e = d + 1; e < count; ++e)
        for (const std::int32_t cut_d : cuts)
          for (const std::int32_t cut_e : cuts) {
            Case c{t, Sign::plus, {}, {}};
            c.neighbor_sign.fill(Sign::plus);
            c.neighbor_sign[d] = c.neighbor_sign[e] = Sign::minus;
            c.cut[d] = cut_d;
            c.cut[e] = cut_e;
            differences.expect(agree(production, c), [&] { return show(c); });
          }
  }
  return differences;
}

/// Every sign of the vertex and of one neighbour, every boundary cut.
Differences compare_single(const Implementation& production) {
  Differences differences;
  for (const certet::Thresholds t : all_thresholds)
    for (const Sign sign : all_signs)
      for (const Sign neighbor : all_signs)
        for (std::size_t d = 0; d < count; ++d)
          for (const std::int32_t cut : boundary_cuts(t)) {
            Case c{t, sign, {}, {}};
            c.neighbor_sign.fill(Sign::on_surface);
            c.neighbor_sign[d] = neighbor;
            c.cut[d] = cut;
            differences.expect(agree(production, c), [&] { return show(c); });
          }
  return differences;
}

/// Random signs everywhere; in most cases the cuts come from few values, so that
/// ties are frequent.
bool survives_random_cases(const Implementation& production) {
  return rc::check("random signs and cuts warp alike", [&] {
    const auto t = *rc::gen::elementOf(std::vector<certet::Thresholds>(
        std::begin(all_thresholds), std::end(all_thresholds)));
    const auto boundary = boundary_cuts(t);
    const auto any_cut = rc::gen::inRange(0, certet::steps + 1);
    const auto few = *rc::gen::container<std::vector<std::int32_t>>(
        3, rc::gen::oneOf(rc::gen::elementOf(boundary), any_cut));
    const bool everything = *rc::gen::weightedElement<bool>({{4, false}, {1, true}});
    const auto any_sign = rc::gen::elementOf(
        std::vector{Sign::minus, Sign::on_surface, Sign::plus, Sign::minus, Sign::plus});
    Case c{t, *any_sign, {}, {}};
    for (Sign& s : c.neighbor_sign) s = *any_sign;
    for (std::int32_t& cut : c.cut) cut = everything ? *any_cut : *rc::gen::elementOf(few);
    if (!agree(production, c)) RC_FAIL(show(c));
  });
}

TEST(Warp, IsTheSameForEveryPattern) {
  const Differences differences = compare_patterns({});
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_EQ(differences.compared(), 2 * 16384 * 4);
}

TEST(Warp, IsTheSameForEveryPairOfEdges) {
  const Differences differences = compare_pairs({});
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_GT(differences.compared(), 91 * 3 * 36);
}

TEST(Warp, IsTheSameForASingleEdge) {
  const Differences differences = compare_single({});
  EXPECT_TRUE(differences.empty()) << differences;
}

TEST(Warp, IsTheSameForRandomCases) { EXPECT_TRUE(survives_random_cases({})); }

/// `warp` anew, with the decisions that a bug may get wrong as parameters.
struct Decisions {
  std::function<bool(std::int32_t cut, std::int32_t threshold)> violates = std::less<>{};
  std::function<bool(std::int64_t, std::int64_t)> nearer = std::less<>{};
  bool weigh_lengths = true;
  bool look_at_signs = true;
};

Implementation deciding(const Decisions& decide) {
  Implementation broken;
  broken.warp = [=](certet::Thresholds t, Sign sign, const NeighborSigns& neighbor_sign,
                    const NeighborCuts& cut) {
    certet::Warping best;
    std::int64_t best_distance = 0;
    for (int d = 0; d < count; ++d) {
      const auto i = static_cast<std::size_t>(d);
      if (decide.look_at_signs ? !certet::opposite(sign, neighbor_sign[i])
                               : sign == neighbor_sign[i])
        continue;
      if (!decide.violates(cut[i], t.in_steps(d))) continue;
      const std::int64_t distance =
          std::int64_t{decide.weigh_lengths ? certet::length_squared(d) : 1} * cut[i] * cut[i];
      if (best.moves() && !decide.nearer(distance, best_distance)) continue;
      best = {static_cast<std::int8_t>(d), cut[i]};
      best_distance = distance;
    }
    return best;
  };
  return broken;
}

TEST(Warp, TheVariantWithoutABugAgrees) {
  EXPECT_TRUE(compare_pairs(deciding({})).empty());
}

TEST(Warp, CatchesAThresholdThatIsNotStrict) {
  const Implementation broken = deciding({.violates = std::less_equal<>{}});
  EXPECT_FALSE(compare_pairs(broken).empty());
  EXPECT_FALSE(compare_single(broken).empty());
  EXPECT_FALSE(survives_random_cases(broken));
}

TEST(Warp, CatchesATieForTheLastDirection) {
  const Implementation broken = deciding({.nearer = std::less_equal<>{}});
  EXPECT_FALSE(compare_patterns(broken).empty());
  EXPECT_FALSE(compare_pairs(broken).empty());
  EXPECT_FALSE(survives_random_cases(broken));
}

TEST(Warp, CatchesTheFarthestCut) {
  EXPECT_FALSE(compare_pairs(deciding({.nearer = std::greater<>{}})).empty());
}

TEST(Warp, CatchesLengthsThatAreNotWeighed) {
  EXPECT_FALSE(compare_pairs(deciding({.weigh_lengths = false})).empty());
}

TEST(Warp, CatchesANeighborOnTheSurfaceTakenForOpposite) {
  EXPECT_FALSE(compare_single(deciding({.look_at_signs = false})).empty());
}

}  // namespace
