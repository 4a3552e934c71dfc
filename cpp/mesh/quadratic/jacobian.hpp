#pragma once
/// \file
/// The Jacobian determinant of a tetrahedron of ten nodes, bounded from below.
///
/// With b_kl the Bézier points of the element (the corners b_kk, and 2 x_kl - (b_kk + b_ll) / 2
/// for a middle node x_kl) its derivative towards corner a is the linear function with the values
/// 2 (b_ka - b_k0) at the corners k.  The determinant of the three derivatives is therefore a
/// cubic, of which the 20 Bernstein coefficients are means of determinants with a column from
/// each: the least of them is a lower bound on the element, and at its corners it is attained.

#include <algorithm>
#include <array>
#include <cstddef>

#include "certet/lattice/coord3.hpp"
#include "certet/middle_nodes.hpp"

namespace certet::quadratic {

__extension__ using Wide = __int128;

template <class Number>
using Vector = std::array<Number, 3>;

/// Twice the Bézier points, by the corners that they lie between.
template <class Number>
using DoubledPoints = std::array<std::array<Vector<Number>, 4>, 4>;

template <class Number>
constexpr Number determinant(const Vector<Number>& a, const Vector<Number>& b,
                             const Vector<Number>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Six times the Bernstein coefficients of the determinant.  That of a straight element is
/// constant: six times its own volume.
template <class Number>
constexpr std::array<Number, 20> jacobian_coefficients(const DoubledPoints<Number>& doubled) {
  std::array<std::array<Vector<Number>, 4>, 3> derivative;  // towards corner a + 1, at corner k
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis)
        derivative[a][k][axis] = doubled[k][a + 1][axis] - doubled[k][0][axis];
  const auto term = [&](std::size_t i, std::size_t j, std::size_t k) {
    return determinant(derivative[0][i], derivative[1][j], derivative[2][k]);
  };
  std::array<Number, 20> coefficients;
  std::size_t at = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j)
      for (std::size_t k = j; k < 4; ++k)
        coefficients[at++] =
            i == k   ? 6 * term(i, i, i)
            : i == j ? 2 * (term(i, i, k) + term(i, k, i) + term(k, i, i))
            : j == k ? 2 * (term(i, j, j) + term(j, i, j) + term(j, j, i))
                     : term(i, j, k) + term(i, k, j) + term(j, i, k) + term(j, k, i) +
                           term(k, i, j) + term(k, j, i);
  return coefficients;
}

/// The Bézier points of an element on the lattice: its corners in steps, and how its middle
/// nodes are bent, in half steps.
inline DoubledPoints<Wide> doubled_points(const std::array<Coord3, 4>& corners,
                                          const std::array<Coord3, 6>& bends) {
  DoubledPoints<Wide> doubled;
  const auto sum = [](Coord3 p, Coord3 q) {
    return Vector<Wide>{Wide{p.x} + q.x, Wide{p.y} + q.y, Wide{p.z} + q.z};
  };
  for (std::size_t k = 0; k < 4; ++k) doubled[k][k] = sum(corners[k], corners[k]);
  for (std::size_t e = 0; e < 6; ++e) {
    const auto& [k, l] = tet_edges[e];
    const Vector<Wide> twice = sum(bends[e], bends[e]);
    Vector<Wide> point = sum(corners[k], corners[l]);
    for (std::size_t axis = 0; axis < 3; ++axis) point[axis] += twice[axis];
    doubled[k][l] = doubled[l][k] = point;
  }
  return doubled;
}

/// The same of one in the world, by its ten nodes.
inline DoubledPoints<double> doubled_points(const std::array<Point3, 4>& corners,
                                            const std::array<Point3, 6>& middles) {
  DoubledPoints<double> doubled;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis) doubled[k][k][axis] = 2 * corners[k][axis];
  for (std::size_t e = 0; e < 6; ++e) {
    const auto& [k, l] = tet_edges[e];
    for (std::size_t axis = 0; axis < 3; ++axis)
      doubled[k][l][axis] = doubled[l][k][axis] =
          4 * middles[e][axis] - (corners[k][axis] + corners[l][axis]);
  }
  return doubled;
}

}  // namespace certet::quadratic
