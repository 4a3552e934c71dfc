/// \file
/// Starts the OCaml runtime before the first test, but not for a mere listing.

#include <gtest/gtest.h>

#include "certified.hpp"

/// The runtime never frees the stack on which it notices stack overflows.
/// LeakSanitizer asks for this function, where it is in use.
// NOLINTNEXTLINE(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() {
  return "leak:caml_setup_stack_overflow_detection\n";
}

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
