// Stands in for range.cpp where interval arithmetic was left out.

#include "range.hpp"

namespace certet {

Range range_of(Operation, std::span<const Range>, bool) { return {}; }

}  // namespace certet
