#pragma once
/// \file
/// The memory of the machine and of this process, in bytes.

#include <cstdint>

namespace certet::command {

/// What can be had without pushing others out; 0 where the system does not say.
std::uint64_t available_memory();

/// The most that this process has had resident so far.
std::uint64_t peak_memory();

/// Makes allocations fail beyond this, so that a run ends with a sentence
/// rather than at the kernel's hand.
void limit_memory(std::uint64_t bytes);

}  // namespace certet::command
