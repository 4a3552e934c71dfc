/// What is added up exactly, and the bounds.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "certet/quality.hpp"

namespace certet {
namespace {

constexpr std::int64_t greatest = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();

TEST(WideSum, ProductIsASumOfEqualTerms) {
  for (const std::int64_t factor : {INT64_C(0), INT64_C(7), INT64_C(-7), least, greatest}) {
    WideSum sum;
    for (std::uint64_t times = 0; times < 40; ++times, sum += factor)
      ASSERT_EQ(WideSum::product(factor, times), sum) << factor << " x " << times;
  }
  EXPECT_EQ(WideSum::product(std::int64_t{1} << 50, std::uint64_t{1} << 40),
            (WideSum{0, std::int64_t{1} << 26}));
}

TEST(WideSum, HoldsWhatOverflowsSixtyFourBits) {
  WideSum sum;
  for (int i = 0; i < 8; ++i) sum += greatest;
  EXPECT_EQ(sum.value(), std::ldexp(1.0, 66));
  for (int i = 0; i < 8; ++i) sum += least;
  EXPECT_EQ(sum.value(), -8.0);
  sum += 8;
  EXPECT_EQ(sum, WideSum{});
}

TEST(WideSum, KeepsSmallNumbersOfBothSigns) {
  constexpr std::int64_t numbers[] = {0, 1, -1, greatest, least};
  for (const std::int64_t n : numbers) {
    WideSum sum;
    sum += n;
    EXPECT_EQ(sum.value(), static_cast<double>(n));
  }
}

TEST(WideSum, CarriesBetweenItsWords) {
  WideSum sum{~std::uint64_t{0}, 0};
  sum += 1;
  EXPECT_EQ(sum, (WideSum{0, 1}));
  sum += -1;
  EXPECT_EQ(sum, (WideSum{~std::uint64_t{0}, 0}));
  WideSum negative{0, -1};
  EXPECT_EQ(negative.value(), -std::ldexp(1.0, 64));
  negative += WideSum{5, 1};
  EXPECT_EQ(negative.value(), 5.0);
}

TEST(Quality, NothingAddsNothing) {
  Quality quality;
  quality += Quality{};
  EXPECT_EQ(quality.tets, 0u);
  EXPECT_EQ(quality.min_dihedral, 180.0);
  EXPECT_EQ(quality.max_dihedral, 0.0);
  EXPECT_EQ(quality.volume, 0.0);
}

TEST(Methods, PromiseWhatTheirTheoremsDo) {
  const auto promises = [](Method method, std::string_view theorem, double least,
                           double greatest) {
    const AngleBounds& bounds = facts(method).bounds;
    EXPECT_EQ(bounds.theorem, theorem);
    EXPECT_EQ(bounds.min_dihedral, least);
    EXPECT_EQ(bounds.max_dihedral, greatest);
  };
  promises(Method::embedded, "SettledBoundsInDegrees", 10.77, 164.76);
  promises(Method::angles, "DihedralBounds", 10.77, 164.76);
  promises(Method::embedding, "DihedralBoundsEmbedding", 9.27, 161.46);
  promises(Method::midpoint, "MidpointBounds", 30.0, 135.0);
  promises(Method::key, "CertifiedKeySweptMesh", 11.18, 157.13);
}

TEST(Methods, AreFoundByTheirNames) {
  for (std::size_t row = 0; row < methods.size(); ++row) {
    EXPECT_EQ(static_cast<std::size_t>(methods[row].method), row);
    EXPECT_EQ(method_named(methods[row].name), methods[row].method);
  }
  EXPECT_EQ(method_named("bisect"), std::nullopt);
  EXPECT_EQ(method_names(), "embedded, angles, embedding, midpoint, key");
}

}  // namespace
}  // namespace certet
