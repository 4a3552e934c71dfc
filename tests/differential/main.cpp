/// \file
/// Starts the OCaml runtime before the first test, but not for a mere listing.

#include <gtest/gtest.h>

#include "certified.hpp"

namespace {

class CertifiedRuntime : public testing::Environment {
 public:
  void SetUp() override { certified::start(); }
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  testing::AddGlobalTestEnvironment(new CertifiedRuntime);
  return RUN_ALL_TESTS();
}
