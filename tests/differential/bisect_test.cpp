/// \file
/// Bisection, watched through a mesh.

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>

#include "certified.hpp"
#include "differences.hpp"
#include "domains.hpp"
#include "engine_bisection.hpp"

namespace {

using certet::Sign;

using engine_bisection::SignOnEdge;

/// The production side: the cut of an edge in a direction from its + end.
using Bisection = std::function<std::int64_t(int direction, const SignOnEdge&)>;

struct NamedSign {
  std::string name;
  SignOnEdge sign;
};

/// A surface after each of many steps, and on it; and signs that follow no
/// surface at all.
std::vector<NamedSign> signs_on_edge() {
  std::set<std::int64_t> cuts{0, certet::steps - 1};
  for (int bit = 0; bit < certet::step_bits; ++bit)
    for (const std::int64_t beside : {-1, 0, 1}) cuts.insert((std::int64_t{1} << bit) + beside);
  for (const certet::Thresholds t : {certet::angle_thresholds, certet::embedding_thresholds})
    for (const int direction : {0, 6})
      for (const std::int64_t beside : {-1, 0, 1}) {
        cuts.insert(t.in_steps(direction) + beside);
        cuts.insert(certet::steps - t.in_steps(direction) + beside);
      }
  std::vector<NamedSign> signs;
  for (const std::int64_t cut : cuts) {
    signs.push_back({"inside up to " + std::to_string(cut), [=](std::int64_t t) {
                       return t <= cut ? Sign::plus : Sign::minus;
                     }});
    signs.push_back({"on the surface at " + std::to_string(cut), [=](std::int64_t t) {
                       return t < cut ? Sign::plus : t == cut ? Sign::on_surface : Sign::minus;
                     }});
  }
  for (std::uint64_t seed = 0; seed < 50; ++seed)
    signs.push_back({"noise " + std::to_string(seed), [=](std::int64_t t) {
                       const std::uint64_t h = mixed(seed, t);
                       if (h % 16 == 0) return Sign::on_surface;
                       return h >> 32 & 1 ? Sign::plus : Sign::minus;
                     }});
  return signs;
}

Differences compare(const Bisection& production) {
  Differences differences;
  for (const NamedSign& s : signs_on_edge()) {
    const std::int64_t theirs = certified::bisect(s.sign);
    for (int direction = 0; direction < certet::direction_count; ++direction) {
      const std::int64_t ours = production(direction, s.sign);
      differences.expect(ours == theirs, [&] {
        return s.name + ", direction " + std::to_string(direction) + ": " +
               std::to_string(ours) + " instead of " + std::to_string(theirs);
      });
    }
  }
  return differences;
}

TEST(Bisect, IsTheSame) {
  const Differences differences = compare(engine_bisection::bisect);
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_GT(differences.compared(), 2000);
}

/// Bisection anew, with what a bug may get wrong as parameters.
Bisection deciding(int rounds, bool stops_on_surface, std::int64_t off) {
  return [=](int, const SignOnEdge& sign) {
    std::int64_t low = 0;
    for (int round = certet::step_bits - 1; round >= certet::step_bits - rounds; --round) {
      const std::int64_t middle = low + (std::int64_t{1} << round);
      const Sign s = sign(middle);
      if (s == Sign::on_surface && stops_on_surface) return middle;
      if (s == Sign::plus) low = middle;
    }
    return low + off;
  };
}

TEST(Bisect, TheVariantWithoutABugAgrees) {
  EXPECT_TRUE(compare(deciding(certet::step_bits, true, 0)).empty());
}

TEST(Bisect, CatchesALostRound) {
  EXPECT_FALSE(compare(deciding(certet::step_bits - 1, true, 0)).empty());
}

TEST(Bisect, CatchesTheOuterEnd) {
  EXPECT_FALSE(compare(deciding(certet::step_bits, true, 1)).empty());
}

TEST(Bisect, CatchesAMissedSurface) {
  EXPECT_FALSE(compare(deciding(certet::step_bits, false, 0)).empty());
}

}  // namespace
