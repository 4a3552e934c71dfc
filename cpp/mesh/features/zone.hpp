#pragma once
/// \file
/// The part of a mesh that is near its features, with numbers of its own.

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "certet/mesh.hpp"
#include "curve.hpp"
#include "mesh/optimise/stars.hpp"

namespace certet::features {

using optimising::StarTet;
using optimising::Stars;
using Number = std::uint32_t;  ///< of a vertex, in the zone

/// Vertices of the zone may move if all of their tetrahedra are in it.
class Zone {
 public:
  /// Of all vertices near one of the edges.  `holds_border`: those where the shape is cut off stay.
  Zone(const Mesh& mesh, std::span<const FeatureEdge> edges, bool holds_border);

  [[nodiscard]] std::size_t size() const { return numbers_.size(); }
  [[nodiscard]] std::uint64_t in_mesh(Number v) const { return numbers_[v]; }
  [[nodiscard]] Coord3 place(Number v) const { return places_[v]; }
  [[nodiscard]] Coord3 origin(Number v) const { return origins_[v]; }
  void put(Number v, Coord3 place) { places_[v] = place; }
  [[nodiscard]] const std::array<Number, 4>& tet(std::uint64_t t) const { return tets_[t]; }

  /// Whether it may move at all.
  [[nodiscard]] bool is_free(Number v) const { return free_[v] != 0; }
  [[nodiscard]] bool on_surface(Number v) const { return !fans_[v].empty(); }
  /// Around a free vertex.
  [[nodiscard]] std::span<const StarTet> around(Number v) const {
    return is_free(v) ? stars_.around(star_[v]) : std::span<const StarTet>();
  }
  /// Of a free one, by growing numbers.
  [[nodiscard]] std::span<const Number> neighbours(Number v) const { return neighbours_[v]; }
  /// Triangles of the boundary at a free vertex: their other points, anticlockwise from outside,
  /// each triangle beginning where the one before ends.
  [[nodiscard]] std::span<const std::array<Number, 2>> fan(Number v) const { return fans_[v]; }
  /// Free vertices of the boundary that were within two long edges of a line of points when the
  /// zone was made, and some more, by growing numbers.
  [[nodiscard]] std::vector<Number> near(std::span<const Vector> line) const;
  [[nodiscard]] bool are_neighbours(Number v, Number w) const;
  /// Whether they are two ends of an edge of the boundary.
  [[nodiscard]] bool are_on_edge(Number v, Number w) const;

 private:
  template <class Index>
  void gather(const Mesh& mesh, std::span<const Tet<Index>> tets,
              std::span<const FeatureEdge> edges);
  void find_fans(const Mesh& mesh, std::span<const std::int32_t> labels);

  bool holds_border_;

  std::vector<std::uint64_t> numbers_;
  std::vector<Coord3> places_, origins_;
  std::vector<std::array<Number, 4>> tets_;
  std::vector<std::uint8_t> free_;
  std::vector<std::uint32_t> star_;
  Stars stars_{std::span<const Tet<Number>>(), std::span<const std::uint8_t>()};
  std::vector<std::vector<Number>> neighbours_;
  std::vector<std::vector<std::array<Number, 2>>> fans_;
  std::unordered_map<std::uint64_t, std::vector<Number>> cubes_;
};

}  // namespace certet::features
