#pragma once
/// \file
/// Parts as they are drawn: surfaces of known edges, corners and volume.

#include <random>

#include "certet/surface.hpp"

namespace parts {

using Polygon = std::vector<std::array<double, 2>>;  ///< anticlockwise, seen from above

/// A surface, and what is known of it.
struct Part {
  certet::TriangleSurface surface;
  double volume = 0;
};

/// Above a polygon that a point sees all of, from 0 to a height.
Part prism(const Polygon& polygon, std::array<double, 2> centre, double height);
Part box(double a, double b, double c);
Part cylinder(double radius, double height, int sides);
/// A beam whose cross-section is an L, of legs 1 thick.
Part angle_beam(double leg, double length);
/// Of five points.
Part star(double outer, double inner, double height);
/// Half a cylinder against a block: sharp edges of which one runs into the other smoothly.
Part rounded_block(double radius, double length, double height, int sides);

/// A drop of radius 1 with a tip of 90 degrees: the edge of its top ends at the corner where it begins.
Part drop(double height, int sides);

/// Turned and shifted at random.
Part placed(Part part, std::mt19937_64& random);
/// Made finer, by cutting each triangle in four, and rough: its points are moved by noise.
certet::TriangleSurface rough(certet::TriangleSurface surface, int times, double noise,
                              std::mt19937_64& random);
certet::TriangleSurface ball(int times);

}  // namespace parts
