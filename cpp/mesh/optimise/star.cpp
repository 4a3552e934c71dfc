#include "star.hpp"

#include <algorithm>
#include <utility>

namespace certet::optimising {
namespace {

/// Of the corners from each on, in an order that keeps the volume positive.
constexpr std::array<std::array<std::size_t, 4>, 4> from_corner{
    {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}}};

/// Inward normals of the faces, as long as twice their areas; the first is across from the
/// vertex that moves.
struct Faces {
  std::array<Vector, 4> normals;
  std::array<double, 4> squares;
};

[[gnu::always_inline]] inline Faces faces_of(const std::array<Vector, 3>& edges, const Vector& across) {
  const auto& [a, b, c] = edges;
  Faces faces{{across, cross(b, c), cross(c, a), cross(a, b)}, {}};
  for (std::size_t i = 0; i < 4; ++i) faces.squares[i] = dot(faces.normals[i], faces.normals[i]);
  return faces;
}

std::array<Vector, 3> moved_edges(const std::array<Vector, 3>& edges, const Vector& by) {
  return {edges[0] - by, edges[1] - by, edges[2] - by};
}

}  // namespace

bool Spoke::keeps(const Vector& by, const Bars& bars) const {
  const std::array<Vector, 3> moved = moved_edges(edges, by);
  const Faces faces = faces_of(moved, across);
  if (!(dot(moved[0], faces.normals[1]) > rounding_volume)) return false;
  bool all = true;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      // The cosine has the sign of -n.n'.
      const double product = dot(faces.normals[i], faces.normals[j]);
      const double bar = product < 0 ? bars.acute : bars.obtuse;
      all = all && product * product < bar * (faces.squares[i] * faces.squares[j]);
    }
  return all;
}

double Spoke::worst_after(const Vector& by) const {
  const Faces faces = faces_of(moved_edges(edges, by), across);
  double greatest = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double product = dot(faces.normals[i], faces.normals[j]);
      greatest =
          std::max(greatest, product * product / (faces.squares[i] * faces.squares[j]));
    }
  return greatest;
}

/// With n the normal of a face at the vertex and e the edge of that face across from the vertex,
/// w.n grows by (w x e).dp.
void Spoke::gradients(double least, std::vector<Vector>& out) const {
  const auto& [a, b, c] = edges;
  const Faces faces = faces_of(edges, across);
  const std::array<Vector, 4> opposite{Vector{0, 0, 0}, c - b, a - c, b - a};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const Vector &m = faces.normals[i], &n = faces.normals[j];
      const double product = dot(m, n), squares = faces.squares[i] * faces.squares[j];
      const double value = product * product / squares;
      if (value < least) continue;
      const Vector of_product = cross(n, opposite[i]) + cross(m, opposite[j]);
      const Vector of_squares = (1 / faces.squares[i]) * cross(m, opposite[i]) +
                                (1 / faces.squares[j]) * cross(n, opposite[j]);
      out.push_back((2 * product / squares) * of_product - (2 * value) * of_squares);
    }
}

void Star::add(std::uint64_t tet, const TetCorners& corners, std::size_t vertex, double worst) {
  const auto& order = from_corner[vertex];
  Spoke spoke{{}, {}, worst, tet};
  for (std::size_t i = 0; i < 3; ++i)
    spoke.edges[i] = between(corners[order[0]], corners[order[i + 1]]);
  const auto& [a, b, c] = spoke.edges;
  spoke.across = cross(c - a, b - a);
  spokes_.push_back(spoke);
}

void Star::move(const Vector& by) {
  for (Spoke& spoke : spokes_) {
    spoke.edges = moved_edges(spoke.edges, by);
    spoke.worst = static_cast<float>(spoke.worst_after({0, 0, 0}));
  }
}

double Star::worst() const {
  double greatest = 0;
  for (const Spoke& spoke : spokes_) greatest = std::max(greatest, spoke.worst);
  return greatest;
}

bool Star::keeps(const Vector& by, const Bars& bars) {
  for (std::size_t i = 0; i < spokes_.size(); ++i)
    if (!spokes_[i].keeps(by, bars)) {
      std::swap(spokes_[i], spokes_[i / 2]);
      return false;
    }
  return true;
}

}  // namespace certet::optimising
