#pragma once
/// \file
/// Which points of a mesh lie where its domain is cut off.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/border.hpp"
#include "certet/frame.hpp"
#include "certet/lattice/coord3.hpp"
#include "certet/method.hpp"

namespace certet::core {

/// The two vertices, in lattice units, whose edge has its middle here (in steps):
/// of a long edge the lower first, of a short one the even one.
std::array<Coord3, 2> ends_of_middle(Coord3 middle);

/// Whether a point of a mesh, in steps, that lies on its surface lies where the
/// domain is cut off by one of the boxes.  A cut in the middle of its edge does
/// if that edge leaves the box.
bool is_on_border(Coord3 point, std::span<const BorderBox> boxes, Cuts cuts);

/// The boxes at which a domain is cut off, their sides called after the axes of the world to which
/// a frame leads.
class BorderSides {
 public:
  BorderSides(std::span<const BorderBox> boxes, Cuts cuts, const Frame& frame);

  [[nodiscard]] bool empty() const { return boxes_.empty(); }

  /// The sides at which a point of the mesh, in steps, that lies on its surface lies; none of a
  /// point for which `is_on_border` does not hold.
  [[nodiscard]] Sides at(Coord3 point) const;

 private:
  struct Box {
    BorderBox box;
    std::array<std::uint8_t, side_count> names;
  };
  std::vector<Box> boxes_;
  Cuts cuts_;
};

/// To which side a face of the boundary belongs, whose corners are at some: to the one that has
/// most of them, of several the first (in the order xmin, xmax, ymin, ymax, zmin, zmax).  So a
/// face that cuts off an edge or a corner of the box has one side, too.
std::size_t side_of_face(const std::array<Sides, 3>& corners);

}  // namespace certet::core
