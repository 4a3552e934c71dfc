/// \file
/// The numbers that both sides must share.

#include <gtest/gtest.h>

#include "certet/lattice/coord3.hpp"
#include "certet/lattice/direction.hpp"
#include "certet/lattice/warp.hpp"
#include "certified.hpp"
#include "differences.hpp"

namespace {

struct Numbers {
  std::int64_t step_bits = certet::step_bits;
  std::int64_t steps = certet::steps;
  certet::Thresholds angle = certet::angle_thresholds;
  certet::Thresholds embedding = certet::embedding_thresholds;
  certet::Thresholds no_warp = certet::no_warp_thresholds;
  certet::Thresholds key = certet::key_thresholds;
  std::array<certet::Coord3, certet::direction_count> offsets = certet::direction_offset;
};

Differences compare(const Numbers& production) {
  Differences differences;
  const auto expect = [&](bool agree, const char* what) {
    differences.expect(agree, [&] { return what; });
  };
  const auto same = [](certet::Thresholds a, certified::Thresholds b) {
    bool agree = a.long_edge == b.long_edge && a.short_edge == b.short_edge;
    for (int d = 0; d < certet::direction_count; ++d)
      agree = agree && a.in_steps(d) == certified::threshold_steps(b, certet::is_long(d));
    return agree;
  };
  const certified::Constants certificate = certified::constants();
  expect(production.step_bits == certificate.step_bits, "the number of step bits");
  expect(production.steps == certificate.steps, "the number of steps");
  expect(production.steps / 2 == certificate.midpoint_cut, "the midpoint");
  expect(same(production.angle, certificate.angle), "the angle thresholds");
  expect(same(production.embedding, certificate.embedding), "the embedding thresholds");
  expect(same(production.no_warp, certificate.no_warp), "the no-warp thresholds");
  expect(same(production.key, certificate.key), "the thresholds of the key");
  for (int d = 0; d < certet::direction_count; ++d) {
    const certified::Direction& direction =
        certificate.directions[static_cast<std::size_t>(d)];
    expect(production.offsets[static_cast<std::size_t>(d)] == direction.offset,
           "an offset, or the order of the directions");
    expect(certet::is_long(d) == direction.is_long, "the kind of a direction");
    expect(certet::length_squared(d) == direction.length_squared, "the length of a direction");
  }
  return differences;
}

TEST(Constants, AreTheSame) {
  const Differences differences = compare({});
  EXPECT_TRUE(differences.empty()) << differences;
}

TEST(Constants, CatchesAThreshold) {
  Numbers broken;
  broken.angle.long_edge += 1;
  EXPECT_FALSE(compare(broken).empty());
}

TEST(Constants, CatchesSwappedDirections) {
  Numbers broken;
  std::swap(broken.offsets[6], broken.offsets[7]);
  EXPECT_FALSE(compare(broken).empty());
}

TEST(Constants, CatchesACoarserDivision) {
  Numbers broken;
  broken.steps /= 2;
  EXPECT_FALSE(compare(broken).empty());
}

}  // namespace
