#pragma once
/// \file
/// Fourth stage: numbers for points and tetrahedra, by how many each row has.

#include <cstdint>
#include <vector>

#include "certet/context.hpp"
#include "graded_cells.hpp"
#include "sign_planes.hpp"
#include "window.hpp"

namespace certet::core {

/// The number of the first point and of the first tetrahedron of every row of a
/// window, and of the first point of every row of the layer behind it, which the
/// window's tetrahedra use.
class RowNumbers {
 public:
  RowNumbers(const SignPlanes& planes, const Lattice& lattice, Window window, Context& context);
  /// Those of the same mesh once it is graded, by what it has then less of the lattice, and more:
  /// `uniform` are those of the whole of it, `graded` outlives the object.
  RowNumbers(const RowNumbers& uniform, const SignPlanes& planes, const Lattice& lattice,
             Context& context, const GradedCells& graded);

  /// What the mesh is graded by, if it is.
  [[nodiscard]] const GradedCells* graded() const { return graded_; }

  [[nodiscard]] std::uint64_t first_point(int j, int k) const { return points_[at(j, k)]; }
  [[nodiscard]] std::uint64_t first_tet(int j, int k) const { return tets_[at(j, k)]; }
  [[nodiscard]] Window window() const { return window_; }
  /// Of the window.
  [[nodiscard]] std::uint64_t point_count() const {
    return first_point(0, window_.end) - first_point(0, window_.begin);
  }
  [[nodiscard]] std::uint64_t tet_count() const {
    return first_tet(0, window_.end) - first_tet(0, window_.begin);
  }

  /// No number of a point that the window's tetrahedra use is greater.
  [[nodiscard]] std::uint64_t last_point() const { return points_.back(); }

  /// Counts from these on, as if so many came before the window; from 0 without.
  void start_from(std::uint64_t point, std::uint64_t tet);

  [[nodiscard]] std::uint64_t bytes() const {
    return sizeof(std::uint64_t) * (points_.size() + tets_.size());
  }

 private:
  [[nodiscard]] std::size_t at(int j, int k) const {
    return static_cast<std::size_t>(k - window_.begin) * rows_ + static_cast<std::size_t>(j);
  }

  /// From how many each row has to how many come before it.
  void number_rows();

  const GradedCells* graded_ = nullptr;
  Window window_;
  std::size_t rows_;  ///< of a layer
  std::vector<std::uint64_t> points_, tets_;  ///< by layer and row; one entry more at the end
};

}  // namespace certet::core
