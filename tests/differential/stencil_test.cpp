/// \file
/// The stencils: all 81 sign patterns, and all 11,664 face cases of the paper.

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "certified.hpp"
#include "differences.hpp"
#include "implementation.hpp"
#include "vertex_arena.hpp"

namespace {

using certet::CornerSigns;
using certet::Stencil;
using certet::StencilVertex;
using certified::Handle;

PlacedTets certified_tets(const CornerSigns& signs, const std::array<Coord3, 4>& vertices) {
  VertexArena arena(vertices);
  return arena.placed(certified::unstructured_tets(
      [&](Handle h) { return signs[VertexArena::corner(h)]; },
      [&](Handle a, Handle b) { return arena.cut(a, b); }, {0, 1, 2, 3}));
}

std::string show(const CornerSigns& signs) {
  std::string text;
  for (const Sign s : signs) text += "-0+"[static_cast<int>(s)];
  return text;
}

Differences compare_patterns(const Implementation& production) {
  Differences differences;
  const auto vertices =
      certified::structured_tet({{0, 0, 0}, certet::StructuredTetCase::I2}).vertices;
  for (int pattern = 0; pattern < certet::pattern_count; ++pattern) {
    const CornerSigns signs = certet::pattern_signs(pattern);
    differences.expect(place(production.unstructured_tets(signs), vertices) ==
                           certified_tets(signs, vertices),
                       [&] { return "signs " + show(signs); });
  }
  return differences;
}

/// A structured tetrahedron and its neighbour across face `face`, for all signs
/// of their five vertices.
void compare_face(const Implementation& production, const certet::StructuredTetId& id,
                  std::size_t face, Differences& differences) {
  const certet::StructuredTet tet = certified::structured_tet(id);
  const certet::FaceNeighbor neighbor = tet.neighbors[face];
  const certet::StructuredTet other = certified::structured_tet(neighbor.id);
  for (int assignment = 0; assignment < 243; ++assignment) {
    const CornerSigns signs = certet::pattern_signs(assignment % 81);
    // Lined up by `order` the two differ at the vertex across from the face.
    CornerSigns lined_up = signs;
    lined_up[face] = static_cast<Sign>(assignment / 81);
    CornerSigns other_signs{};
    for (std::size_t i = 0; i < 4; ++i) other_signs[neighbor.order[i]] = lined_up[i];

    const auto agree = [&](const CornerSigns& s, const std::array<Coord3, 4>& v) {
      return place(production.unstructured_tets(s), v) == certified_tets(s, v);
    };
    differences.expect(agree(signs, tet.vertices) && agree(other_signs, other.vertices), [&] {
      return "case " + std::string(certet::case_names[static_cast<std::size_t>(id.orientation)]) +
             ", face " + std::to_string(face + 1) + ", signs " + show(signs) + " and " +
             show(other_signs);
    });
  }
}

Differences compare_faces(const Implementation& production) {
  Differences differences;
  for (const certet::StructuredTetCase orientation : certified::all_cases())
    for (std::size_t face = 0; face < 4; ++face)
      compare_face(production, {{0, 0, 0}, orientation}, face, differences);
  return differences;
}

TEST(Stencil, IsTheSameFor81Patterns) {
  const Differences differences = compare_patterns({});
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_EQ(differences.compared(), 81);
}

TEST(Stencil, IsTheSameFor11664FaceCases) {
  const Differences differences = compare_faces({});
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_EQ(differences.compared(), 11664);
}

/// The same implementation, but for one pattern changed by `spoil`.
template <class Spoil>
Implementation with(const CornerSigns& pattern, const Spoil& spoil) {
  Implementation broken;
  broken.unstructured_tets = [=](const CornerSigns& signs) {
    Stencil stencil = certet::unstructured_tets(signs);
    if (signs == pattern) spoil(stencil);
    return stencil;
  };
  return broken;
}

constexpr Sign p = Sign::plus;
constexpr Sign m = Sign::minus;
constexpr Sign o = Sign::on_surface;

void expect_caught(const Implementation& broken) {
  EXPECT_FALSE(compare_patterns(broken).empty());
  EXPECT_FALSE(compare_faces(broken).empty());
}

TEST(Stencil, CatchesASwappedDiagonal) {
  // ++0- leaves the quadrilateral v1 v2 m24 m14: here with the other diagonal.
  expect_caught(with({p, p, o, m}, [](Stencil& s) {
    const StencilVertex v1{0, 0}, v2{1, 1}, v3{2, 2}, m14{0, 3}, m24{1, 3};
    s.tets = {{{v2, v1, m24, v3}, {v1, m14, m24, v3}}};
  }));
}

TEST(Stencil, CatchesACutFromTheWrongEnd) {
  expect_caught(with({p, m, m, m}, [](Stencil& s) {
    std::swap(s.tets[0][1].a, s.tets[0][1].b);
  }));
}

TEST(Stencil, CatchesAMirroredTetrahedron) {
  expect_caught(with({o, p, p, m}, [](Stencil& s) { std::swap(s.tets[1][0], s.tets[1][1]); }));
}

TEST(Stencil, CatchesAMissingTetrahedron) {
  expect_caught(with({p, p, p, m}, [](Stencil& s) { s.count = 2; }));
}

TEST(Stencil, CatchesAKeptOnSurfaceTetrahedron) {
  expect_caught(with({o, o, o, o}, [](Stencil& s) {
    s = certet::unstructured_tets({p, p, p, p});
  }));
}

}  // namespace
