#pragma once
/// \file
/// Running out of memory as an error of the library.

#include <new>

#include "certet/error.hpp"

namespace certet::core {

/// What work() gives.  \throws Error `too_large`, in this sentence, where memory does not hold it.
template <class Work>
auto within_memory(const char* sentence, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, sentence);
  }
}

}  // namespace certet::core
