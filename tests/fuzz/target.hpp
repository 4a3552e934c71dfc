#pragma once
/// \file
/// What fuzzing is aimed at: one function for each reader, and one for the core.

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

using Bytes = std::span<const std::uint8_t>;

/// A promise that was broken.
struct Finding : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Works on any bytes.  What it throws, and what it dies of, is a finding.
struct Target {
  std::string_view name;  ///< of its folder in corpus/ too
  void (*run)(Bytes);
  bool planted = false;  ///< it has a defect, which must be found
};

/// All that were built in.
const std::vector<Target>& targets();

/// \throws Finding where there is none of this name.
const Target& target_named(std::string_view name);

}  // namespace fuzz
