#pragma once
/// \file
/// Triangles to draw, with points of their own.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/formats.hpp"
#include "separating_faces.hpp"
#include "vector.hpp"

namespace certet::view {

/// The points that a selection of triangles has, numbered anew in their order.
class PointSubset {
 public:
  explicit PointSubset(std::size_t points) : used_(points, false) {}

  void add(const std::array<std::uint64_t, 3>& triangle) {
    for (const std::uint64_t point : triangle) used_[point] = true;
  }
  /// When all triangles are added.
  void number();
  [[nodiscard]] std::uint32_t operator[](std::uint64_t point) const { return number_[point]; }
  /// The number of each point in the mesh.
  [[nodiscard]] const std::vector<std::uint64_t>& points() const { return points_; }

 private:
  std::vector<bool> used_;
  std::vector<std::uint32_t> number_;
  std::vector<std::uint64_t> points_;
};

/// The box around all points of the faces.
Box box_of(const FileMesh& mesh, std::span<const SeparatingFace> faces);

/// The box around all points that tetrahedra have.
Box box_of(const FileMesh& mesh);

}  // namespace certet::view
