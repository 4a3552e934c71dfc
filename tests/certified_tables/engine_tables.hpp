#pragma once
/// \file
/// Every constant of the engine that the certificate has an opinion on.

#include <array>
#include <cstddef>

#include "lattice/cell_tables.hpp"
#include "lattice/graded_tets.hpp"
#include "certet/lattice/key_stencil.hpp"
#include "certet/lattice/lattice_limits.hpp"
#include "certet/lattice/material_stencil.hpp"
#include "certet/method.hpp"
#include "certet/lattice/sign.hpp"
#include "certet/lattice/stencil.hpp"
#include "certet/lattice/structured_tet.hpp"
#include "certet/lattice/tiling.hpp"
#include "certet/lattice/warp.hpp"
#include "certet/lattice/well_shaped.hpp"
#include "engine/cuts.hpp"
#include "engine/link.hpp"
#include "mesh/boundary.hpp"
#include "mesh/quality/shape_counter.hpp"

namespace certet::tables {

/// The values of a function on the numbers below n.
template <std::size_t n, class Function>
auto values(const Function& function) {
  std::array<decltype(function(0)), n> list{};
  for (std::size_t i = 0; i < n; ++i) list[i] = function(static_cast<int>(i));
  return list;
}

// The name of a constant is the constant, so that no other can stand under it.
#define CERTET_CONSTANT(name) visit(#name, name)

/// Calls visit(name, value) for the constants that headers hold.
template <class Visit>
void for_each_constant(const Visit& visit) {
  CERTET_CONSTANT(case_count);
  CERTET_CONSTANT(order_1234);
  CERTET_CONSTANT(order_2143);
  CERTET_CONSTANT(structured_tet_table);

  CERTET_CONSTANT(direction_count);
  CERTET_CONSTANT(direction_offset);
  CERTET_CONSTANT(lattice_tiling);

  CERTET_CONSTANT(pattern_count);
  CERTET_CONSTANT(stencil_table);
  CERTET_CONSTANT(cut_order_count);
  CERTET_CONSTANT(key_stencil_count);
  CERTET_CONSTANT(cut_orders);
  CERTET_CONSTANT(key_stencil_table);

  CERTET_CONSTANT(moved_corner);
  CERTET_CONSTANT(shared_owner);
  CERTET_CONSTANT(likeness_count);
  CERTET_CONSTANT(material_pattern_count);
  CERTET_CONSTANT(material_patterns);
  CERTET_CONSTANT(pattern_of_likeness);
  CERTET_CONSTANT(material_stencil_table);
  CERTET_CONSTANT(least_angle);
  CERTET_CONSTANT(greatest_angle);

  CERTET_CONSTANT(step_bits);
  CERTET_CONSTANT(steps);
  CERTET_CONSTANT(core::midpoint_cut);
  CERTET_CONSTANT(threshold_denominator);
  CERTET_CONSTANT(angle_thresholds);
  CERTET_CONSTANT(embedding_thresholds);
  CERTET_CONSTANT(no_warp_thresholds);
  CERTET_CONSTANT(key_thresholds);
  CERTET_CONSTANT(methods);

  CERTET_CONSTANT(core::whole_link);
  CERTET_CONSTANT(core::link_ring);
  CERTET_CONSTANT(core::link_triangles);
  CERTET_CONSTANT(core::long_link_edges);
  CERTET_CONSTANT(core::connected_sets);

  CERTET_CONSTANT(core::grid_count);
  CERTET_CONSTANT(core::grids);
  CERTET_CONSTANT(core::corner_kinds);
  CERTET_CONSTANT(core::family_count);
  CERTET_CONSTANT(core::kind_count);
  CERTET_CONSTANT(core::families);
  CERTET_CONSTANT(core::edges_of);
  CERTET_CONSTANT(core::family_directions);
  CERTET_CONSTANT(core::edge_end_count);
  CERTET_CONSTANT(core::edge_ends);
  CERTET_CONSTANT(core::cell_tet_count);
  CERTET_CONSTANT(core::cell_vertex_count);
  CERTET_CONSTANT(core::cell);
  CERTET_CONSTANT(core::output_orders);
  CERTET_CONSTANT(core::interior_size);
  CERTET_CONSTANT(core::interior_vertices);

  CERTET_CONSTANT(core::graded_kinds);
  CERTET_CONSTANT(core::flag_count);
  CERTET_CONSTANT(core::flags);
  CERTET_CONSTANT(core::graded_tets);

  CERTET_CONSTANT(coordinate_limit);
  CERTET_CONSTANT(anchor_limit);
  CERTET_CONSTANT(cells_limit);
  CERTET_CONSTANT(core::edge_limit);
  CERTET_CONSTANT(core::outward_faces);
}

#undef CERTET_CONSTANT

/// The same for what is no table but a function on a few values: all of them.
template <class Visit>
void for_each_function(const Visit& visit) {
  using enum Sign;
  static constexpr std::array signs{minus, on_surface, plus};
  visit("signs", signs);
  visit("sign_of_bits", std::array{sign_of_bits(0, 0), sign_of_bits(0, 1), sign_of_bits(1, 0)});
  visit("opposite", values<3>([](int a) {
    return values<3>([&](int b) { return opposite(Sign{static_cast<std::uint8_t>(a)},
                                                  Sign{static_cast<std::uint8_t>(b)}); });
  }));
  visit("pattern_signs", values<pattern_count>(pattern_signs));
  visit("pattern_index",
        values<pattern_count>([](int n) { return pattern_index(pattern_signs(n)); }));

  visit("cases", values<case_count>([](int c) {
    using enum StructuredTetCase;
    return std::array{I1, I2, I3, I4, J1, J2, J3, J4, K1, K2, K3, K4}[static_cast<std::size_t>(c)];
  }));
  visit("right_handed", values<case_count>([](int c) {
    return right_handed(static_cast<StructuredTetCase>(c));
  }));

  visit("is_long", values<direction_count>(is_long));
  visit("length_squared", values<direction_count>(length_squared));
  visit("thresholds_in_steps", std::array{
      values<direction_count>([](int d) { return angle_thresholds.in_steps(d); }),
      values<direction_count>([](int d) { return embedding_thresholds.in_steps(d); }),
      values<direction_count>([](int d) { return no_warp_thresholds.in_steps(d); }),
      values<direction_count>([](int d) { return key_thresholds.in_steps(d); })});

  constexpr std::size_t last = core::graded_kinds.size() - 1;  // a pyramid's name asks for its parent
  visit("core::names_tet", values<last>([](int kind) {
    return values<core::flag_count>([&](int flag) {
      return core::names_tet(static_cast<core::GradedKind>(kind),
                             core::flags[static_cast<std::size_t>(flag)]);
    });
  }));
  visit("core::neighbor", values<core::grid_count>([](int grid) {
    return values<direction_count>([&](int d) {
      return core::neighbor(static_cast<core::Grid>(grid), static_cast<std::size_t>(d));
    });
  }));
}

template <class Visit>
void for_each_table(const Visit& visit) {
  for_each_constant(visit);
  for_each_function(visit);
}

}  // namespace certet::tables
