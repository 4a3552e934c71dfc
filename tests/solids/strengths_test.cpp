/// \file
/// Which solid is stronger, and which names are refused.

#include <gtest/gtest.h>

#include "certet/error.hpp"
#include "domains/solids/strengths.hpp"

namespace certet {
namespace {

using Names = std::vector<std::string>;
using Order = std::vector<Material>;

TEST(Strengths, ALaterSolidIsStronger) {
  EXPECT_EQ(strongest_first({"a"}, {}), (Order{1}));
  EXPECT_EQ(strongest_first({"a", "b", "c"}, {}), (Order{3, 2, 1}));
}

TEST(Strengths, ThePriorityComesFirst) {
  EXPECT_EQ(strongest_first({"a", "b", "c"}, {"a", "b", "c"}), (Order{1, 2, 3}));
  EXPECT_EQ(strongest_first({"a", "b", "c"}, {"b", "c", "a"}), (Order{2, 3, 1}));
  EXPECT_EQ(strongest_first({"a", "b", "c", "d"}, {"b"}), (Order{2, 4, 3, 1}));
}

void expect_refused(const Names& names, const Names& priority, const std::string& words) {
  try {
    static_cast<void>(strongest_first(names, priority));
    ADD_FAILURE() << "not refused: " << words;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_option);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(Strengths, NamesAreUniqueAndKnown) {
  expect_refused({"a", ""}, {}, "no name");
  expect_refused({"a", "b", "a"}, {}, "two materials are called 'a'");
  expect_refused({"a", "b"}, {"c"}, "'c', which is no material");
  expect_refused({"a", "b"}, {"b", "b"}, "'b' twice");
}

}  // namespace
}  // namespace certet
