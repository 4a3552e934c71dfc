// A reader that hands on memory which it did not fill.

#include <algorithm>
#include <memory>

#include "targets.hpp"

namespace fuzz {

void planted_memory(Bytes bytes) {
  constexpr std::size_t promised = 64;
  const std::unique_ptr<std::uint8_t[]> voxels(new std::uint8_t[promised]);
  std::copy_n(bytes.begin(), std::min(bytes.size(), promised), voxels.get());
  if (std::ranges::count(voxels.get(), voxels.get() + promised, 7) > 32)
    throw Finding("more than half of the voxels are 7");
}

}  // namespace fuzz
