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
