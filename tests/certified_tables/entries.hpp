#pragma once
/// \file
/// The parts of a constant, whatever its type, down to its entries: numbers,
/// enumerators and names.

#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "certet/method.hpp"
#include "certet/lattice/key_stencil.hpp"
#include "certet/lattice/material_stencil.hpp"
#include "certet/lattice/stencil.hpp"
#include "certet/lattice/tiling.hpp"
#include "lattice/cell_tables.hpp"
#include "lattice/graded_tets.hpp"
#include "certet/lattice/warp.hpp"
#include "certet/lattice/well_shaped.hpp"
#include "engine/link.hpp"

namespace certet::tables {

using LatticeTiling = std::remove_const_t<decltype(lattice_tiling)>;

template <class T, class... Types>
concept OneOf = (std::is_same_v<std::remove_const_t<T>, Types> || ...);

template <class T>
concept Entry = std::is_arithmetic_v<T> || std::is_enum_v<T> || OneOf<T, std::string_view>;

// A structured binding names all fields or does not compile, so that none is left out.
template <class T>
concept OfTwo = OneOf<T, core::VertexRef, core::Family, core::EdgeEnds, StructuredTetId,
                      FaceNeighbor, StencilVertex, Stencil, CutPair, MaterialTet, MaterialStencil,
                      SquaredCotangent, Thresholds, core::LinkEdge, core::Flag, LatticeTiling::Edge>;
template <class T>
concept OfThree = OneOf<T, Coord3, core::Shift, core::EdgeRef, core::CellTables,
                        StructuredTetShape, AngleBounds, CutOrders>;
template <class T>
concept OfFour = OneOf<T, LatticeTiling>;

/// Calls visit(part) for each part of an array or a structure, in order.
template <class T, std::size_t n, class Visit>
void for_each_part(const std::array<T, n>& array, const Visit& visit) {
  for (const T& part : array) visit(part);
}
template <class T, std::size_t n, class Visit>
void for_each_part(std::array<T, n>& array, const Visit& visit) {
  for (T& part : array) visit(part);
}
template <OfTwo T, class Visit>
void for_each_part(T& value, const Visit& visit) {
  auto& [a, b] = value;
  visit(a), visit(b);
}
template <OfThree T, class Visit>
void for_each_part(T& value, const Visit& visit) {
  auto& [a, b, c] = value;
  visit(a), visit(b), visit(c);
}

template <OfFour T, class Visit>
void for_each_part(T& value, const Visit& visit) {
  auto& [a, b, c, d] = value;
  visit(a), visit(b), visit(c), visit(d);
}
/// All that a method does and promises, but for the sentence that tells people of it, and
/// whether the product cuts materials apart with it, which the theorem does not ask.
template <OneOf<MethodFacts> T, class Visit>
void for_each_part(T& value, const Visit& visit) {
  auto& [method, name, cuts, thresholds, settles, follow, interfaces, bounds, sentence] = value;
  visit(method), visit(name), visit(cuts), visit(thresholds), visit(settles), visit(follow),
      visit(bounds);
}

/// Calls visit(entry) for every entry, in order.
template <class T, class Visit>
void for_each_entry(T& value, const Visit& visit) {
  if constexpr (Entry<T>)
    visit(value);
  else
    for_each_part(value, [&](auto& part) { for_each_entry(part, visit); });
}

/// Makes an entry a little wrong.
template <Entry T>
void spoil(T& entry) {
  if constexpr (std::is_same_v<T, bool>)
    entry = !entry;
  else if constexpr (std::is_enum_v<T>)
    entry = static_cast<T>(static_cast<std::underlying_type_t<T>>(entry) + 1);
  else if constexpr (std::is_floating_point_v<T>)
    entry = std::nextafter(entry, std::numeric_limits<T>::infinity());
  else if constexpr (std::is_integral_v<T>)
    ++entry;
  else
    entry.remove_prefix(1);
}

}  // namespace certet::tables
