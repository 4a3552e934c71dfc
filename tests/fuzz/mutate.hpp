#pragma once
/// \file
/// Damaged copies of good inputs, for builds without libFuzzer.

#include <cstdint>
#include <random>
#include <vector>

namespace fuzz {

using Input = std::vector<std::uint8_t>;

/// A copy with one to four changes: bits, bytes, runs of bytes, numbers, and
/// pieces of `other`.  Depends on the generator's state alone.
Input mutated(const Input& input, const Input& other, std::mt19937_64& random);

}  // namespace fuzz
