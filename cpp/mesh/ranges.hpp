#pragma once
/// \file
/// Many numbers, range by range on several threads.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "engine/parallel.hpp"

namespace certet::core {

/// What find(begin, end) gives for each range of at most `length` of the numbers below `count`,
/// in order, so that sums of rounded numbers are always the same.
template <class Find>
auto in_ranges(std::size_t count, std::size_t length, Stage stage, Context& context,
               const Find& find) {
  std::vector<std::invoke_result_t<const Find&, std::size_t, std::size_t>> parts(
      (count + length - 1) / length);
  parallel_for(context, stage, static_cast<std::int64_t>(parts.size()),
               [&](std::int64_t task) {
                 const auto part = static_cast<std::size_t>(task);
                 const std::size_t begin = part * length;
                 parts[part] = find(begin, std::min(begin + length, count));
               });
  return parts;
}

/// Tetrahedra that one task measures.
inline constexpr std::size_t tets_per_task = std::size_t{1} << 16;

}  // namespace certet::core
