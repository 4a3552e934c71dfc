#pragma once
/// \file
/// How far points are from where they should be.

#include <algorithm>
#include <cmath>
#include <vector>

#include "certet/frame.hpp"

struct Deviation {
  double greatest = 0, rms = 0;

  /// `distance` is a point's from the truth, with or without a sign.
  template <class Distance>
  Deviation(const std::vector<certet::Point3>& points, const Distance& distance) {
    for (const certet::Point3& p : points) {
      const double d = std::abs(distance(p));
      greatest = std::max(greatest, d);
      rms += d * d;
    }
    rms = std::sqrt(rms / static_cast<double>(points.size()));
  }
};

/// Half of the distance between the two planes of a direction that points lie between.
struct Flatness {
  double half_width = 0;

  /// `height` is a point's, along the direction.
  template <class Height>
  Flatness(const std::vector<certet::Point3>& points, const Height& height) {
    double low = 1e9, high = -1e9;
    for (const certet::Point3& p : points) {
      low = std::min(low, height(p));
      high = std::max(high, height(p));
    }
    half_width = 0.5 * (high - low);
  }
};
