// What is refused before a lattice is laid, and before a mesh is placed in the world.

#include "certet/lattice/lattice_limits.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "certet/lattice.hpp"
#include "certet/error.hpp"
#include "certet/stuffing.hpp"
#include "domains.hpp"

namespace certet {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::array wrong_sizes{0.0, -1.0, infinite, std::numeric_limits<double>::quiet_NaN()};
constexpr std::array far_sizes{5e-324, 0.99 * least_size, 1.01 * greatest_size, 1e300};

template <class Work>
ErrorCode code_of(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "no error";
  return {};
}

TEST(LatticeLimits, Cells) {
  EXPECT_EQ(checked_cells(cells_limit), cells_limit);
  EXPECT_EQ(checked_cells(7), 7);
  EXPECT_EQ(cells_limit, 31990);
  for (const double cells : {cells_limit + 1.0, 1e300, std::nan("")})
    EXPECT_EQ(code_of([=] { checked_cells(cells); }), ErrorCode::too_large);
}

TEST(LatticeLimits, Margins) {
  EXPECT_EQ(checked_margin(1), 1);
  for (const std::int32_t margin : {0, -1})
    EXPECT_EQ(code_of([=] { checked_margin(margin); }), ErrorCode::bad_option);
}

TEST(LatticeLimits, Sizes) {
  for (const double size : {least_size, 1.0, greatest_size}) EXPECT_EQ(checked_size(size), size);
  for (const double size : wrong_sizes)
    EXPECT_EQ(code_of([=] { checked_size(size); }), ErrorCode::bad_option);
  for (const double size : far_sizes)
    EXPECT_EQ(code_of([=] { checked_size(size); }), ErrorCode::too_large);
}

TEST(LatticeLimits, SizesAreCheckedBeforeAMeshIsPlaced) {
  Context context;
  const auto ball = domains::of_level(domains::sphere(0, 0, 0, 3));
  const Stuffing stuffing(ball, {{-8, -8, -8}, {8, 8, 8}}, {}, context);
  for (const double size : far_sizes) {
    Frame frame;
    frame.size = size;
    EXPECT_EQ(code_of([&] { emit(stuffing, frame, context); }), ErrorCode::too_large);
    EXPECT_EQ(code_of([&] { lattice_around({{-1, -1, -1}, {1, 1, 1}}, size, 2); }),
              ErrorCode::too_large);
  }
}

}  // namespace
}  // namespace certet
