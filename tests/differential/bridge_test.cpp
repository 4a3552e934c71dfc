/// \file
/// The bridge itself: exceptions, threads, integers, closures within closures.

#include "c_client.h"
#include "certified.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <thread>

namespace {

using certet::Coord3;
using certet::Sign;

struct Thrown {
  int number;
};

std::string failure_of(const std::function<void()>& run) {
  try {
    run();
  } catch (const certified::Failure& failure) {
    return failure.what();
  }
  return "";
}

TEST(Bridge, WhatAClosureThrowsReachesTheCaller) {
  for (int call = 0; call < 1000; ++call) {
    try {
      certified::bisect([&](std::int64_t) -> Sign { throw Thrown{call}; });
      FAIL() << "nothing was thrown";
    } catch (const Thrown& thrown) {
      EXPECT_EQ(thrown.number, call);
    }
  }
  EXPECT_EQ(certified::bisect([](std::int64_t) { return Sign::plus; }), 65535);
}

TEST(Bridge, WhatAnInnerClosureThrowsPassesBothCalls) {
  const auto outer = [](std::int64_t) {
    certified::bisect([](std::int64_t) -> Sign { throw Thrown{7}; });
    return Sign::plus;
  };
  EXPECT_THROW(certified::bisect(outer), Thrown);
}

TEST(Bridge, AClosureMayCallAndCatch) {
  const auto outer = [](std::int64_t t) {
    EXPECT_THROW(certified::bisect([](std::int64_t) -> Sign { throw Thrown{7}; }), Thrown);
    const std::int64_t inner = certified::bisect([](std::int64_t u) {
      return u < 12345 ? Sign::plus : Sign::minus;
    });
    return t <= inner ? Sign::plus : Sign::minus;
  };
  EXPECT_EQ(certified::bisect(outer), 12344);
}

TEST(Bridge, AnotherThreadIsRefused) {
  std::string sentence;
  std::thread([&] { sentence = failure_of([] { certified::constants(); }); }).join();
  EXPECT_EQ(sentence, "the OCaml runtime belongs to another thread");
  sentence.clear();
  std::thread([&] { sentence = failure_of([] { certified::start(); }); }).join();
  EXPECT_EQ(sentence, "the OCaml runtime belongs to another thread");
}

TEST(Bridge, StartingAgainDoesNothing) {
  certified::start();
  EXPECT_EQ(certified::constants().step_bits, 16);
}

constexpr std::int64_t largest = (std::int64_t{1} << 62) - 1;
constexpr std::int64_t smallest = -(std::int64_t{1} << 62);

certified::Warping warp_to(std::int64_t cut) {
  return certified::warp(
      {largest / 256 + 1, 0}, Sign::plus,
      [](int d) { return d == 0 ? Sign::minus : Sign::plus; }, [=](int) { return cut; });
}

TEST(Bridge, IntegersOf63BitsPass) {
  EXPECT_EQ(warp_to(largest), (certified::Warping{0, largest}));
  EXPECT_EQ(warp_to(smallest), (certified::Warping{0, smallest}));
}

TEST(Bridge, LargerIntegersAreErrors) {
  EXPECT_EQ(failure_of([] { warp_to(largest + 1); }),
            "4611686018427387904 does not fit in 63 bits");
  EXPECT_EQ(failure_of([] { warp_to(smallest - 1); }),
            "-4611686018427387905 does not fit in 63 bits");
  EXPECT_NE(failure_of([] { certified::threshold_steps({largest + 1, 0}, true); }), "");
  // 2^62 as a result: the certificate's integers hold it, OCaml's do not.
  EXPECT_NE(failure_of([] {
              certified::threshold_steps({std::int64_t{1} << 54, 0}, true);
            }).find("Overflow"),
            std::string::npos);
  EXPECT_EQ(certified::threshold_steps({-(std::int64_t{1} << 54), 0}, true), smallest);
}

TEST(Bridge, CoordinatesBeyond32BitsAreErrors) {
  constexpr std::int32_t top = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(failure_of([] {
              certified::structured_tet({{top, 0, 0}, certet::StructuredTetCase::I1});
            }),
            "2147483649 does not fit in 32 bits");
}

TEST(Bridge, AStrangeSignOrCaseIsAnError) {
  EXPECT_NE(failure_of([] {
              certified::bisect([](std::int64_t) { return static_cast<Sign>(3); });
            }).find("3 is no sign"),
            std::string::npos);
  EXPECT_NE(failure_of([] {
              certified::structured_tet({{0, 0, 0}, static_cast<certet::StructuredTetCase>(12)});
            }),
            "");
}

TEST(Bridge, ServesAProgramInC) {
  const char* const wrong = use_the_c_header();
  EXPECT_EQ(wrong, nullptr) << wrong;
}

}  // namespace
