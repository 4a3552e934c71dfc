#pragma once
/// \file
/// What a shape is made of, at positions anywhere.

#include <cstdint>
#include <optional>
#include <vector>

#include "certet/placed_domain.hpp"

namespace certet::distance {

/// A shape's materials or, where they are not told apart, 1 for all that is inside.
struct Sides {
  const PlacedDomain& domain;
  bool materials;

  /// What is known of all points in a box.
  [[nodiscard]] std::optional<Material> of(const LatticeBox& box) const;
};

/// Asks a shape about several positions at once.
class Question {
 public:
  explicit Question(const Sides& sides);

  void clear();
  /// A position in lattice units, which is rounded to steps.  Beyond the lattice is outside.
  void add(const Point3& position);
  [[nodiscard]] std::size_t size() const { return positions_.size(); }
  void ask();
  [[nodiscard]] Material operator[](std::size_t i) const { return answers_[i]; }

 private:
  const Sides& sides_;
  Point3 low_, high_;  ///< of the lattice
  std::vector<Coord3> positions_;
  std::vector<bool> beyond_;
  std::vector<Sign> signs_;
  std::vector<Material> answers_;
};

}  // namespace certet::distance
