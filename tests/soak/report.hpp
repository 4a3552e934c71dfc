#pragma once
/// \file
/// What a run found, for people and for programs.

#include <cstdint>
#include <string>
#include <vector>

#include "verify.hpp"

namespace soak {

struct Summary {
  std::uint64_t seed, first;
  std::vector<Verdict> verdicts;  ///< of the domains first, first + 1, …
};

/// How many meshes have a fault.
std::uint64_t faulty(const Summary& summary);

/// A table by kind, and the first faults with the command that shows each again.
std::string as_markdown(const Summary& summary);
std::string as_json(const Summary& summary);

}  // namespace soak
