#include "view/packing.hpp"

#include <gtest/gtest.h>

#include "view/histogram.hpp"

namespace certet::view {
namespace {

std::string base64(std::string_view text) {
  Packing packing;
  for (const char c : text) packing.byte(static_cast<std::uint8_t>(c));
  return packing.base64();
}

TEST(Packing, Base64IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Packing, NumbersTakeFewBytes) {
  Packing packing;
  packing.natural(127);     // 7f
  packing.natural(300);     // ac 02
  packing.integer(-1);      // 01
  packing.integer(64);      // 80 01
  EXPECT_EQ(packing.base64(), base64({"\x7f\xac\x02\x01\x80\x01", 6}));
}

TEST(Packing, TextIsNoMarkup) {
  EXPECT_EQ(escaped("<b>&'\""), "&lt;b&gt;&amp;&#39;&quot;");
  EXPECT_EQ(grouped_digits(1234567), "1\u202f234\u202f567");
}

TEST(Histogram, HasABarForEveryBinThatIsNotEmpty) {
  const std::array<std::uint64_t, 4> counts{3, 0, 1, 1'000'000};
  const std::string drawing = svg({"id", "a < b", counts, 0, 4, "", 1, {{2, true}}});
  std::size_t bars = 0;
  for (std::size_t at = 0; (at = drawing.find("<rect", at)) != std::string::npos; ++at) ++bars;
  EXPECT_EQ(bars, 3u);
  EXPECT_NE(drawing.find("data-count=\"1000000\""), std::string::npos);
  EXPECT_NE(drawing.find("a &lt; b"), std::string::npos);
  EXPECT_EQ(drawing.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace certet::view
