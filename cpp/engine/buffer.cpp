#include "certet/buffer.hpp"

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace certet::detail {
namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;

}  // namespace

void* allocate_array(std::size_t bytes) {
  const std::size_t alignment = bytes < huge_page ? alignof(std::max_align_t) : huge_page;
  const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
  void* const array = std::aligned_alloc(alignment, rounded == 0 ? alignment : rounded);
  if (array == nullptr) throw std::bad_alloc();
#ifdef __linux__
  // First touches of small pages would cost more than all of the stuffing.
  if (alignment == huge_page) madvise(array, rounded, MADV_HUGEPAGE);
#endif
  return array;
}

void release_array(void* array) noexcept { std::free(array); }

}  // namespace certet::detail
