#pragma once
/// \file
/// The nearest place where a shape is made of something else.

#include <array>
#include <cstddef>
#include <span>

#include "sides.hpp"

namespace certet::distance {

/// A ball around a point.  It grows until one of its probes is in another material than the
/// point, and shrinks to where none is; then the direction of that probe turns, by less and less,
/// as long as a smaller ball reaches another material in a direction nearby.  All lengths are in
/// lattice units.  The probes of many balls are asked for at once.
class Ball {
 public:
  explicit Ball(const Point3& centre) : centre_(centre) {}

  void add_probes(Question& question) const;
  /// The answers to its probes, from the first one on.
  void take(const Question& question, std::size_t first);

  [[nodiscard]] bool is_open() const { return stage_ < Stage::found; }
  /// Whether nothing else was found within a long edge.
  [[nodiscard]] bool is_far() const { return stage_ == Stage::far; }
  /// Goes on from a place, elsewhere, that is known to be made of something else.
  void reach(const Point3& place);
  [[nodiscard]] double radius() const { return outer_; }
  [[nodiscard]] const Point3& centre() const { return centre_; }

 private:
  enum class Stage { start, grow, shrink, turn, settle, found, far };
  static constexpr std::size_t most = 14;

  /// The probes as they are asked for: directions, and the radius that they have in common.
  struct Probes {
    std::array<Point3, most> directions;
    std::size_t count = 0;
    double radius = 0;
    void add(const Point3& direction) { directions[count++] = direction; }
  };
  [[nodiscard]] Probes probes() const;
  [[nodiscard]] double middle() const { return inner_ + (outer_ - inner_) / 2; }
  void grow(const Probes& changed);
  void shrink(const Probes& changed);
  void turn(const Probes& changed);

  Point3 centre_;
  Stage stage_ = Stage::start;
  Material own_ = 0;
  double inner_ = 0, outer_ = 0;  ///< no probe is, or one is, in another material
  Probes best_;                   ///< that one or, before they are told apart, all that are
  double aside_ = 0.5;            ///< how far the direction turns next
  unsigned turns_ = 0;            ///< how often that became less
};

}  // namespace certet::distance
