#pragma once
/// \file
/// Calls of the system that a signal may interrupt.

#include <cerrno>

namespace certet::formats {

/// What call() gives, which is made again as long as a signal interrupts it.
template <class Call>
auto uninterrupted(const Call& call) {
  auto given = call();
  while (given < 0 && errno == EINTR) given = call();
  return given;
}

}  // namespace certet::formats
