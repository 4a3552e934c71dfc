/// The same bytes for every compiler, number of threads, and cut into slabs:
/// the checksums are those of the committed table.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "cases.hpp"
#include "certet/function_domain.hpp"
#include "domains.hpp"

namespace repeatability {
namespace {

const std::vector<std::string>& table() {
  static const std::vector<std::string> lines = [] {
    std::vector<std::string> read;
    std::ifstream file(CERTET_CHECKSUMS);
    for (std::string text; std::getline(file, text);) read.push_back(text);
    return read;
  }();
  return lines;
}

bool listed(const std::string& text) { return std::ranges::count(table(), text) == 1; }

TEST(Repeatability, TheTableListsEveryCaseOnce) {
  EXPECT_EQ(table().size(), shapes().size() * manners().size());
}

TEST(Repeatability, AnyNumberOfThreadsInMemory) {
  for (const Shape& shape : shapes())
    for (const Manner& manner : manners())
      for (const int threads : {1, 2, 3, 8}) {
        const std::string found = line(shape, manner, in_memory(shape, manner, threads));
        EXPECT_TRUE(listed(found)) << found << " with " << threads << " threads";
      }
}

TEST(Repeatability, AnyNumberOfThreadsSlabBySlab) {
  for (const Shape& shape : shapes())
    for (const Manner& manner : manners())
      for (const int threads : {1, 2, 3, 8}) {
        const std::uint64_t max_bytes = threads == 1 ? 0 : std::uint64_t{1} << 20;
        const std::string found = line(shape, manner, streamed(shape, manner, threads, max_bytes));
        EXPECT_TRUE(listed(found)) << found << " with " << threads << " threads";
      }
}

/// The same domain, but for a single position that differs.
class OneSignWrong final : public domains::SignsAlone {
 public:
  using SignsAlone::SignsAlone;
  void row(certet::Coord3 first, std::span<certet::Sign> out) const override {
    SignsAlone::row(first, out);
    if (first.y == 0 && first.z == 0)
      for (std::size_t i = 0; i < out.size(); ++i)
        if (first.x + 2 * static_cast<std::int32_t>(i) == 0) out[i] = certet::Sign::minus;
  }
};

TEST(Repeatability, CatchesOneSignOfManyThousands) {
  Shape shape = shapes().front();
  const auto right = shape.domain;
  shape.domain = std::make_shared<OneSignWrong>(*right);
  for (const Manner& manner : manners())
    EXPECT_FALSE(listed(line(shape, manner, in_memory(shape, manner, 1))));
}

}  // namespace
}  // namespace repeatability
