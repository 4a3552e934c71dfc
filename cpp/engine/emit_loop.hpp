#pragma once
/// \file
/// What emitting points and emitting tetrahedra have in common.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "certet/error.hpp"
#include "parallel.hpp"
#include "window.hpp"

namespace certet::core {

/// Rows that one task emits.
inline constexpr std::int32_t rows_per_task = 32;

/// \throws Error `bad_option` unless there is room for just as many.
inline void check_room(std::size_t room, std::uint64_t needed) {
  if (room != needed)
    throw Error(ErrorCode::bad_option, "there is room for " + std::to_string(room) + " of " +
                                           std::to_string(needed) + " numbers of the mesh");
}

/// Calls emit(j_begin, j_end, k) for pieces of the layers of a window.
template <class Emit>
void for_each_piece(const Lattice& lattice, Window window, Context& context, const Emit& emit) {
  const std::int32_t rows = lattice.cells[1];
  const std::int64_t pieces = (rows + rows_per_task - 1) / rows_per_task;
  parallel_for(context, Stage::emit, pieces * window.layers(), [&](std::int64_t task) {
    const int j = static_cast<int>(task % pieces) * rows_per_task;
    emit(j, std::min(j + rows_per_task, rows), window.begin + static_cast<int>(task / pieces));
  });
}

}  // namespace certet::core
