#pragma once
/// \file
/// Where faces of a solid meet, of which signs alone are known.

#include <optional>
#include <span>
#include <vector>

#include "certet/context.hpp"
#include "jumps.hpp"

namespace certet::features {

/// A place near the line along which two faces meet.
struct OnLine {
  Vector place;
  Wedge wedge;

  /// Of length 1, along the line: with the first face on the left, seen from outside.
  [[nodiscard]] Vector along() const {
    const auto& [left, right] = wedge.normals;
    return unit(wedge.convex ? cross(left, right) : cross(right, left));
  }
};

/// Moves each onto its line, across it, to a few steps; nothing where the faces are not found to go
/// on up to there.
std::vector<std::optional<OnLine>> onto_lines(const Domain& domain, std::span<const OnLine> guesses,
                                              Context& context);

/// One of three faces near a corner, and a way into it from there.
struct CornerFace {
  Vector normal, into;
};

/// The point in which three faces meet, near a place.
std::optional<Vector> onto_corner(const Domain& domain, const Vector& guess,
                                  std::array<CornerFace, 3> faces);

}  // namespace certet::features
