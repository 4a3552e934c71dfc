#pragma once
/// \file
/// Fourth stage: how many points and tetrahedra each row will have.

#include <cstdint>
#include <vector>

#include "certet/context.hpp"
#include "sign_planes.hpp"

namespace certet::core {

/// For every row, in the order (k, j), the number of the first point and of the
/// first tetrahedron; one entry more holds the totals.
struct RowNumbers {
  std::vector<std::uint64_t> first_point;
  std::vector<std::uint64_t> first_tet;
};

RowNumbers count_rows(const SignPlanes& planes, Context& context);

}  // namespace certet::core
