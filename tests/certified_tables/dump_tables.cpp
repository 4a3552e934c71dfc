/// Prints the tables that the C++ engine runs on as Coq terms, for
/// CertifiedTables.v to prove them equal to the certified functions.
///
/// usage: dump_tables [--plant N]   N names a defect to plant (see `plant`)

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>

#include "certet/direction.hpp"
#include "certet/quality.hpp"
#include "certet/stencil.hpp"
#include "certet/structured_tet.hpp"
#include "certet/warp.hpp"
#include "lattice_edges.hpp"
#include "quality/shape_counter.hpp"

namespace {

using namespace certet;

/// Copies of the tables, so that a defect can be planted in them.
struct Tables {
  std::array<StructuredTetShape, case_count> structured = structured_tet_table;
  std::array<Stencil, pattern_count> stencils = stencil_table;
  std::array<Coord3, direction_count> directions = direction_offset;
  std::array<Thresholds, 3> thresholds{angle_thresholds, embedding_thresholds, no_warp_thresholds};
  core::CellTables cell = core::cell;
  std::array<AngleBounds, 3> bounds{proven_bounds(Cuts::bisect, Guarantee::angles),
                                    proven_bounds(Cuts::bisect, Guarantee::embedding),
                                    proven_bounds(Cuts::midpoint, Guarantee::angles)};
  std::array<std::int64_t, 3> limits{coordinate_limit, anchor_limit, quality::edge_limit};
};

void plant(Tables& t, int defect) {
  switch (defect) {
    case 1: std::swap(t.stencils[26].tets[0][0], t.stencils[26].tets[0][1]); break;
    case 2: t.structured[4].neighbors[2].id.anchor.x += 2; break;
    case 3: t.structured[7].right_handed = !t.structured[7].right_handed; break;
    case 4: std::swap(t.directions[6], t.directions[8]); break;
    case 5: ++t.thresholds[0].short_edge; break;
    case 6: t.cell.edge[5][0][3].owner.y ^= 1; break;
    case 7: std::swap(t.cell.corner[11][0], t.cell.corner[11][1]); break;
    case 8: t.bounds[0].min_dihedral += 0.01; break;
    case 9: ++t.limits[1]; break;
    case 10: t.limits[2] *= 2; break;
    default: break;
  }
}

/// Prints a Coq list, one element at a time.
template <class Range, class Print>
void list(const Range& range, const Print& print) {
  std::cout << '[';
  bool first = true;
  for (const auto& element : range) {
    if (!first) std::cout << "; ";
    first = false;
    print(element);
  }
  std::cout << ']';
}

void point(Coord3 p) {
  std::cout << "C3 (" << p.x << ") (" << p.y << ") (" << p.z << ')';
}

template <class Print>
void definition(std::string_view name, std::string_view type, const Print& print) {
  std::cout << "Definition " << name << " : " << type << " :=\n  ";
  print();
  std::cout << ".\n\n";
}

void structured(const Tables& t) {
  definition("CppStructuredTets", "list LatticeRow", [&] {
    list(t.structured, [](const StructuredTetShape& row) {
      std::cout << "\n  (";
      list(row.vertices, point);
      std::cout << ", ";
      list(row.neighbors, [](const FaceNeighbor& n) {
        std::cout << "(STId (";
        point(n.id.anchor);
        std::cout << ") Tet_" << case_names[static_cast<std::size_t>(n.id.orientation)] << ", ";
        list(n.order, [](int o) { std::cout << o; });
        std::cout << ')';
      });
      std::cout << ", " << (row.right_handed ? "RightHanded" : "LeftHanded") << ')';
    });
  });
}

void stencils(const Tables& t) {
  definition("CppStencils", "list (list (list (Z * Z)))", [&] {
    list(t.stencils, [](const Stencil& stencil) {
      std::cout << "\n  ";
      list(stencil, [](const UnstructuredTet& tet) {
        list(tet, [](StencilVertex v) { std::cout << '(' << +v.a << ", " << +v.b << ')'; });
      });
    });
  });
}

void warp(const Tables& t) {
  definition("CppDirections", "list (Coord3 * Z * EdgeKind)", [&] {
    int d = 0;
    list(t.directions, [&](Coord3 offset) {
      std::cout << '(';
      point(offset);
      std::cout << ", " << length_squared(d) << ", " << (is_long(d) ? "Long" : "Short") << ')';
      ++d;
    });
  });
  definition("CppThresholds", "list Thresholds", [&] {
    list(t.thresholds, [](const Thresholds& th) {
      std::cout << "TH " << th.long_edge << ' ' << th.short_edge;
    });
  });
  definition("CppThresholdSteps", "list Z", [&] {
    list(std::array{angle_thresholds.in_steps(0), angle_thresholds.in_steps(6),
                    embedding_thresholds.in_steps(0), embedding_thresholds.in_steps(6)},
         [](std::int32_t s) { std::cout << s; });
  });
  definition("CppStepBits", "Z", [] { std::cout << step_bits; });
  definition("CppSteps", "Z", [] { std::cout << steps; });
}

/// In hundredths of degrees, which they are whole numbers of.
void bounds(const Tables& t) {
  definition("CppBounds", "list (Z * Z)", [&] {
    list(t.bounds, [](const AngleBounds& b) {
      std::cout << '(' << std::lround(100 * b.min_dihedral) << ", "
                << std::lround(100 * b.max_dihedral) << ')';
    });
  });
}

/// The ranges within which nothing overflows.
void limits(const Tables& t) {
  definition("CppLimits", "list Z", [&] {
    list(t.limits, [](std::int64_t limit) { std::cout << limit; });
  });
}

/// The lattice point that the engine means by a vertex, and by the ends of an
/// edge.
Coord3 lattice_point(core::VertexRef v) {
  const int g = v.grid == core::odd ? 1 : 0;
  return 2 * Coord3{v.shift.x, v.shift.y, v.shift.z} + Coord3{g, g, g};
}

Coord3 moved(core::VertexRef v, core::Shift s) {
  return lattice_point(v) + 2 * Coord3{s.x, s.y, s.z};
}

void cell(const Tables& t) {
  definition("CppCorners", "list (list Coord3)", [&] {
    list(t.cell.corner, [&](const auto& corners) {
      list(corners, [&](std::size_t n) { point(lattice_point(t.cell.vertices[n])); });
    });
  });
  definition("CppEdges", "list (list (Coord3 * Coord3))", [&] {
    list(t.cell.edge, [](const auto& edges) {
      std::cout << "\n  ";
      constexpr std::array<std::array<std::size_t, 2>, 6> pairs{
          {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
      list(pairs, [&](const auto& ab) {
        const core::EdgeRef& e = edges[ab[0]][ab[1]];
        const core::Family& family = core::families[e.kind - core::corner_kinds];
        const Coord3 first = moved(family.first, e.owner);
        const Coord3 second = moved(family.second, e.owner);
        std::cout << '(';
        point(e.is_first ? first : second);
        std::cout << ", ";
        point(e.is_first ? second : first);
        std::cout << ')';
      });
    });
  });
}

}  // namespace

int main(int argc, char** argv) {
  Tables tables;
  if (argc == 3 && std::string_view(argv[1]) == "--plant") plant(tables, std::atoi(argv[2]));
  std::cout << "(* Generated by dump_tables from the C++ headers. *)\n"
               "From Coq Require Import ZArith List.\n"
               "From Certet Require Import Lattice.Coord3 Lattice.Direction Lattice.StructuredTet.\n"
               "From Certet Require Import Warp.Warp.\n"
               "From CertetTables Require Import TableTypes.\n"
               "Import ListNotations.\nOpen Scope Z_scope.\n\n";
  structured(tables);
  stencils(tables);
  warp(tables);
  cell(tables);
  bounds(tables);
  limits(tables);
}
