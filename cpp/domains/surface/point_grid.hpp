#pragma once
/// \file
/// Points in cubes, to find those that are near.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "certet/frame.hpp"

namespace certet {

/// Numbers of points in cubes of one side, which is positive.
class PointGrid {
 public:
  explicit PointGrid(double side) : side_(side) {}

  void add(std::uint32_t number, const Point3& point) { cubes_[cube(point)].push_back(number); }

  /// Calls visit(number) for every point in the cube of this point and in the 26
  /// around it: all that are no farther than the side.
  template <class Visit>
  void for_each_near(const Point3& point, const Visit& visit) const {
    const Cube middle = cube(point);
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t z = -1; z <= 1; ++z)
          if (const auto at = cubes_.find({middle.x + x, middle.y + y, middle.z + z});
              at != cubes_.end())
            for (const std::uint32_t number : at->second) visit(number);
  }

 private:
  struct Cube {
    std::int64_t x, y, z;
    bool operator==(const Cube&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Cube& c) const {
      std::uint64_t h = 0;
      for (const std::int64_t n : {c.x, c.y, c.z})
        h = (h ^ static_cast<std::uint64_t>(n)) * 0x9e3779b97f4a7c15U, h ^= h >> 29;
      return static_cast<std::size_t>(h);
    }
  };

  [[nodiscard]] Cube cube(const Point3& p) const {
    const auto index = [this](double c) {
      return static_cast<std::int64_t>(std::floor(std::clamp(c / side_, -4e18, 4e18)));
    };
    return {index(p[0]), index(p[1]), index(p[2])};
  }

  double side_;
  std::unordered_map<Cube, std::vector<std::uint32_t>, Hash> cubes_;
};

}  // namespace certet
