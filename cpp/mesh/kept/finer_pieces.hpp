#pragma once
/// \file
/// The pieces of a shape on a lattice that is finer than its mesh's.

#include <cstdint>
#include <optional>
#include <variant>

#include "certet/kept.hpp"

namespace certet::core {

/// How many pieces a lattice of this size finds, by its points alone; nothing where more
/// than so many of its cells would have to be sampled.
std::optional<std::uint64_t> pieces_at(const SizedShape& shape, double size, Method method,
                                       double most_cells, Context& context);

/// What finer samples have.
struct FinerPieces {
  double size = 0;
  std::uint64_t pieces = 0;
};
/// On a lattice of a quarter of the size or, where that is too much to sample, of half of it;
/// where that is too much too, what it would take.
std::variant<FinerPieces, UncomparedPieces> finer_pieces(const SizedShape& shape,
                                                         const MeshedShape& mesh,
                                                         Context& context);

}  // namespace certet::core
