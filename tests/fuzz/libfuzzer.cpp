// One target as a program of libFuzzer; CERTET_FUZZ_TARGET is its name.

#include <cstdio>
#include <cstdlib>

#include "targets/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    fuzz::CERTET_FUZZ_TARGET({bytes, size});
  } catch (const std::exception& finding) {
    std::fprintf(stderr, "finding: %s\n", finding.what());
    std::abort();  // here, while the input is at hand
  }
  return 0;
}
