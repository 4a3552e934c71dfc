/// \file
/// Two structured tetrahedra that share a face fill both sides of it with the
/// same triangles: 24 kinds of shared faces times 243 sign assignments.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "certet/lattice/structured_tet.hpp"
#include "stencils.hpp"

namespace {

using namespace certet;

/// A vertex of the output: a lattice point twice, or the + and - end of its edge.
using Place = std::pair<Coord3, Coord3>;
using Triangle = std::set<Place>;

/// What the stencil leaves of the face across from corner `apex`.
std::set<Triangle> face_triangles(const Stencil& stencil, const std::array<Coord3, 4>& corners,
                                  std::size_t apex) {
  std::set<Triangle> triangles;
  for (const certet::UnstructuredTet& tet : stencil) {
    Triangle on_face;
    for (const StencilVertex v : tet)
      if (v.a != apex && v.b != apex) on_face.insert({corners[v.a], corners[v.b]});
    if (on_face.size() == 3) triangles.insert(on_face);
  }
  return triangles;
}

struct Count {
  int cases = 0;
  int different = 0;  ///< the face has a + corner, or both sides leave something
  int one_sided = 0;  ///< one side leaves something of a face without a + corner
  int one_sided_not_000 = 0;
};

void compare_face(const Stencils& stencils, const StructuredTetId& id, std::size_t apex,
                  Count& count) {
  const StructuredTet tet = certet::structured_tet(id);
  const certet::FaceNeighbor neighbor = tet.neighbors[apex];
  const StructuredTet other = certet::structured_tet(neighbor.id);
  for (int assignment = 0; assignment < 243; ++assignment) {
    const CornerSigns signs = certet::pattern_signs(assignment % 81);
    CornerSigns other_signs{};
    for (std::size_t i = 0; i < 4; ++i)
      other_signs[neighbor.order[i]] =
          i == apex ? static_cast<Sign>(assignment / 81) : signs[i];
    const auto here = face_triangles(stencils(signs), tet.vertices, apex);
    const auto there =
        face_triangles(stencils(other_signs), other.vertices, neighbor.order[apex]);

    int on_surface = 0;
    bool plus = false;
    for (std::size_t i = 0; i < 4; ++i) {
      if (i == apex) continue;
      plus = plus || signs[i] == Sign::plus;
      on_surface += signs[i] == Sign::on_surface;
    }
    ++count.cases;
    if (here == there) continue;
    if (plus || (!here.empty() && !there.empty())) {
      ++count.different;
    } else {
      ++count.one_sided;
      count.one_sided_not_000 += on_surface != 3;
    }
  }
}

/// Every shared face once: 24 of the 48, as each is seen from both sides.
Count compare(const Stencils& stencils) {
  Count count;
  const auto key = [](const StructuredTetId& id) {
    return std::tuple(id.orientation, id.anchor.x, id.anchor.y, id.anchor.z);
  };
  for (int c = 0; c < certet::case_count; ++c)
    for (std::size_t apex = 0; apex < 4; ++apex) {
      const StructuredTetId id{{0, 0, 0}, static_cast<certet::StructuredTetCase>(c)};
      const StructuredTetId other = certet::structured_tet(id).neighbors[apex].id;
      if (key(id) < key(other)) compare_face(stencils, id, apex, count);
    }
  return count;
}

TEST(Face, NeighborsShareIt) {
  for (int c = 0; c < certet::case_count; ++c) {
    const StructuredTetId id{{0, 0, 0}, static_cast<certet::StructuredTetCase>(c)};
    const StructuredTet tet = certet::structured_tet(id);
    for (std::size_t apex = 0; apex < 4; ++apex) {
      const certet::FaceNeighbor& neighbor = tet.neighbors[apex];
      const StructuredTet other = certet::structured_tet(neighbor.id);
      const auto lined_up = certet::apply(neighbor.order, other.vertices);
      for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(lined_up[i] == tet.vertices[i], i != apex);
      const auto& back = other.neighbors[neighbor.order[apex]];
      EXPECT_EQ(back.id, id);
      EXPECT_EQ(back.order, neighbor.order);
    }
  }
}

TEST(Face, BothSidesHaveTheSameTriangles) {
  const Count count = compare(production);
  EXPECT_EQ(count.cases, 5832);
  EXPECT_EQ(count.different, 0);
  EXPECT_GT(count.one_sided, 0);
  EXPECT_EQ(count.one_sided_not_000, 0);
}

TEST(Face, CatchesASwappedDiagonal) {
  const Count count = compare([](const CornerSigns& signs) {
    constexpr CornerSigns pattern{Sign::plus, Sign::plus, Sign::on_surface, Sign::minus};
    if (signs != pattern) return production(signs);
    const StencilVertex v1{0, 0}, v2{1, 1}, v3{2, 2}, m14{0, 3}, m24{1, 3};
    return Stencil{2, {{{v2, v1, m24, v3}, {v1, m14, m24, v3}}}};
  });
  EXPECT_GT(count.different, 0);
}

TEST(Face, CatchesACutFromTheWrongEnd) {
  const Count count = compare([](const CornerSigns& signs) {
    constexpr CornerSigns pattern{Sign::plus, Sign::minus, Sign::minus, Sign::minus};
    Stencil stencil = production(signs);
    if (signs == pattern) std::swap(stencil.tets[0][2].a, stencil.tets[0][2].b);
    return stencil;
  });
  EXPECT_GT(count.different, 0);
}

}  // namespace
