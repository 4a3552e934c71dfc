#pragma once
/// \file
/// The pieces of a shape on a lattice that is finer than its mesh's.

#include <cstdint>
#include <optional>

#include "certet/kept.hpp"

namespace certet::core {

/// So much finer is that lattice.
inline constexpr double finer_by = 2;

/// How many pieces a lattice of this size finds, by its points alone; nothing where more
/// than so many of its cells would have to be sampled.
std::optional<std::uint64_t> pieces_at(const SizedShape& shape, double size, Method method,
                                       double most_cells, Context& context);

}  // namespace certet::core
