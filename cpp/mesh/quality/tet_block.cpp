#include "tet_block.hpp"

#include <algorithm>
#include <cmath>

#include "angle_bins.hpp"

namespace certet::core {
namespace {

struct Vector {
  double x, y, z;
};

inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double least_of(double a, double b) { return a < b ? a : b; }
inline double greatest_of(double a, double b) { return a > b ? a : b; }

/// Inward normals of the faces, as long as twice their areas; normal[i] is
/// across from vertex i.
struct Normals {
  Vector n0, n1, n2, n3;
};

inline Normals normals(Vector a, Vector b, Vector c) {
  return {cross(c - a, b - a), cross(b, c), cross(c, a), cross(a, b)};
}

struct Vectors {
  Vector a, b, c;
};

inline Vectors vectors(const Edges& edges) {
  const auto vector = [](const Point3& p) { return Vector{p[0], p[1], p[2]}; };
  return {vector(edges.a), vector(edges.b), vector(edges.c)};
}

/// cos |cos| of the angle between two faces, from their inward normals and the
/// product of the normals' squares.
inline double signed_square_cosine(Vector m, Vector n, double squares) {
  const double d = -dot(m, n);
  return d * std::fabs(d) / squares;
}

/// `inline` in the strict sense: compiled anew into each caller, for the
/// machine that the caller is for.
[[gnu::always_inline]] inline void compute_lanes(TetBlock& block) {
  for (std::size_t i = 0; i < lanes; ++i) {
    const Vector u{block.a[0][i], block.a[1][i], block.a[2][i]};
    const Vector v{block.b[0][i], block.b[1][i], block.b[2][i]};
    const Vector w{block.c[0][i], block.c[1][i], block.c[2][i]};
    const auto [n0, n1, n2, n3] = normals(u, v, w);
    const double s0 = dot(n0, n0), s1 = dot(n1, n1), s2 = dot(n2, n2), s3 = dot(n3, n3);
    const double c01 = signed_square_cosine(n0, n1, s0 * s1);
    const double c02 = signed_square_cosine(n0, n2, s0 * s2);
    const double c03 = signed_square_cosine(n0, n3, s0 * s3);
    const double c12 = signed_square_cosine(n1, n2, s1 * s2);
    const double c13 = signed_square_cosine(n1, n3, s1 * s3);
    const double c23 = signed_square_cosine(n2, n3, s2 * s3);
    block.six_volume[i] = dot(u, n1);
    block.least_face[i] = least_of(least_of(s0, s1), least_of(s2, s3));
    block.greatest_face[i] = greatest_of(greatest_of(s0, s1), greatest_of(s2, s3));
    block.signed_square[0][i] = c01;
    block.signed_square[1][i] = c02;
    block.signed_square[2][i] = c03;
    block.signed_square[3][i] = c12;
    block.signed_square[4][i] = c13;
    block.signed_square[5][i] = c23;
    block.least[i] =
        least_of(least_of(least_of(c01, c02), least_of(c03, c12)), least_of(c13, c23));
    block.greatest[i] = greatest_of(
        greatest_of(greatest_of(c01, c02), greatest_of(c03, c12)), greatest_of(c13, c23));
  }
}

#ifdef __x86_64__
/// Without fused multiply-add, which rounds differently.
[[gnu::target("avx2")]] void compute_wide(TetBlock& block) { compute_lanes(block); }
bool can_compute_wide() { return __builtin_cpu_supports("avx2") != 0; }
#else
void compute_wide(TetBlock& block) { compute_lanes(block); }
bool can_compute_wide() { return false; }
#endif

}  // namespace

void TetBlock::compute() {
  static const bool wide = can_compute_wide();
  if (wide)
    compute_wide(*this);
  else
    compute_lanes(*this);
}

void TetBlock::find_cells() {
  for (std::size_t pair = 0; pair < signed_square.size(); ++pair)
    for (std::size_t i = 0; i < lanes; ++i) {
      const double value = signed_square[pair][i];
      // Written so that the not-a-number of a degenerate lane ends in a cell.
      const double bounded = value > -1 ? least_of(value, 1) : -1;
      cell[pair][i] = AngleBins::cell(bounded);
    }
}

void TetBlock::repeat_first(std::size_t count) {
  for (std::size_t i = count; i < lanes; ++i) set(i, get(0));
}

CarefulTet::CarefulTet(const Edges& edges) : edges_(edges) {
  scale();
  const auto [a, b, c] = vectors(edges_);
  six_volume_ = dot(a, cross(b, c));
}

CarefulTet::CarefulTet(const Edges& edges, double six_volume) : edges_(edges) {
  scale();
  six_volume_ = std::scalbn(six_volume, 3 * exponent_);
}

void CarefulTet::scale() {
  double largest = 0;
  bool finite = true;
  for (const Point3& edge : {edges_.a, edges_.b, edges_.c})
    for (const double coordinate : edge) {
      finite = finite && std::isfinite(coordinate);
      largest = std::max(largest, std::fabs(coordinate));
    }
  if (!finite) edges_ = Edges{};
  if (!finite || largest == 0) return;
  // A power of two: exact, and all products stay in range.
  exponent_ = -std::ilogb(largest);
  for (Point3* edge : {&edges_.a, &edges_.b, &edges_.c})
    for (double& coordinate : *edge) coordinate = std::scalbn(coordinate, exponent_);
}

std::array<double, 6> CarefulTet::signed_squared_cotangents() const {
  const auto [a, b, c] = vectors(edges_);
  const auto [n0, n1, n2, n3] = normals(a, b, c);
  // At an edge e, sin = |e| 6V / |m n| and cos = -m.n / |m n|.
  const auto at = [this](Vector m, Vector n, Vector edge) {
    const double d = -dot(m, n);
    const double quotient = d / (std::sqrt(dot(edge, edge)) * six_volume_);
    return d == 0 ? 0.0 : quotient * std::fabs(quotient);
  };
  return {at(n0, n1, c - b), at(n0, n2, c - a), at(n0, n3, b - a),
          at(n1, n2, c),     at(n1, n3, b),     at(n2, n3, a)};
}

}  // namespace certet::core
