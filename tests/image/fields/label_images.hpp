#pragma once
/// \file
/// Images of labels whose true regions are known, or made to be hard.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "certet/image.hpp"

namespace label_images {

using certet::Buffer;
using certet::Image;
using certet::Point3;

/// Voxel (i,j,k) has label(i,j,k).
inline Image image_of(const std::array<std::int64_t, 3>& size,
                      const std::function<int(int, int, int)>& label) {
  Image image;
  image.name = "labels";
  image.size = size;
  Buffer<std::uint16_t> voxels(static_cast<std::size_t>(size[0] * size[1] * size[2]));
  std::size_t at = 0;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) voxels[at++] = static_cast<std::uint16_t>(label(i, j, k));
  image.voxels = std::move(voxels);
  return image;
}

/// Of an image that `image_of` made.
inline Image copy(const Image& image) {
  Image other;
  other.name = image.name;
  other.size = image.size;
  other.spacing = image.spacing;
  const auto& voxels = std::get<Buffer<std::uint16_t>>(image.voxels);
  Buffer<std::uint16_t> copied(voxels.size());
  std::ranges::copy(voxels, copied.begin());
  other.voxels = std::move(copied);
  return other;
}

inline double norm(const Point3& p) { return std::hypot(p[0], p[1], p[2]); }
inline Point3 minus(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Labels 1 and 2 on the sides of a plane through a cube of 40 voxels.
struct ObliquePlane {
  Point3 normal;

  /// Above it, in voxels.
  [[nodiscard]] double height(const Point3& p) const {
    const double offset = 20.3 * (normal[0] + normal[1] + normal[2]);
    return (normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2] - offset) / norm(normal);
  }
  [[nodiscard]] Image image() const {
    return image_of({40, 40, 40}, [this](int i, int j, int k) {
      return height({double(i), double(j), double(k)}) < 0 ? 1 : 2;
    });
  }
};

/// Beyond the image its voxels go on as they end, which bends a plane there.
inline void drop_near_border(std::vector<Point3>& points) {
  std::erase_if(points, [](const Point3& p) {
    return std::ranges::any_of(p, [](double c) { return c < 5 || c > 34; });
  });
}

/// Three balls in a cube of voxels: the second lies in the first, the third reaches over
/// the first's surface and touches the second's, so that three regions and the outside
/// meet in curves.  The later one wins.
struct Balls {
  struct Ball {
    Point3 centre;
    double radius;
  };
  int width;
  std::vector<Ball> balls;

  explicit Balls(int w) : width(w) {
    const double unit = w / 64.0;
    balls = {{{30.3 * unit, 31.1 * unit, 32.4 * unit}, 20 * unit},
             {{24.7 * unit, 27.3 * unit, 30.9 * unit}, 9 * unit},
             {{42.6 * unit, 38.2 * unit, 36.7 * unit}, 11 * unit}};
  }

  [[nodiscard]] int label(const Point3& p) const {
    for (std::size_t b = balls.size(); b-- > 0;)
      if (norm(minus(p, balls[b].centre)) < balls[b].radius) return static_cast<int>(b) + 1;
    return 0;
  }
  [[nodiscard]] Image image() const {
    return image_of({width, width, width}, [this](int i, int j, int k) {
      return label({double(i), double(j), double(k)});
    });
  }

  /// From the nearest point of a sphere that no later ball covers, or of a circle in which
  /// two spheres meet.
  [[nodiscard]] double distance(const Point3& p) const {
    double least = 1e9;
    for (std::size_t b = 0; b < balls.size(); ++b) {
      const Point3 from = minus(p, balls[b].centre);
      Point3 nearest = balls[b].centre;
      for (std::size_t a = 0; a < 3; ++a) nearest[a] += balls[b].radius / norm(from) * from[a];
      if (label(nearest) <= static_cast<int>(b) + 1)
        least = std::min(least, std::abs(norm(from) - balls[b].radius));
      for (std::size_t c = b + 1; c < balls.size(); ++c)
        least = std::min(least, distance_from_circle(p, balls[b], balls[c]));
    }
    return least;
  }

 private:
  static double distance_from_circle(const Point3& p, const Ball& one, const Ball& other) {
    const Point3 between = minus(other.centre, one.centre);
    const double apart = norm(between);
    const double along = (apart * apart + one.radius * one.radius - other.radius * other.radius) /
                         (2 * apart);
    if (std::abs(along) >= one.radius) return 1e9;
    const double radius = std::sqrt(one.radius * one.radius - along * along);
    const Point3 from = minus(p, one.centre);
    double height = 0;
    for (std::size_t a = 0; a < 3; ++a) height += from[a] * between[a] / apart;
    const double away = std::sqrt(std::max(0.0, norm(from) * norm(from) - height * height));
    return std::hypot(height - along, away - radius);
  }
};

/// Voxels of random labels, most of them 0.
inline Image noise(std::uint64_t seed, const std::array<std::int64_t, 3>& size, int labels) {
  std::mt19937_64 random(seed);
  return image_of(size, [&](int, int, int) {
    const int drawn = static_cast<int>(random() % static_cast<unsigned>(2 * labels));
    return drawn < labels ? drawn + 1 : 0;
  });
}

/// Blobs of random labels: where the smallest of some random waves decides.
inline Image blobs(std::uint64_t seed, const std::array<std::int64_t, 3>& size, int labels) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<std::array<double, 5>> waves;
  for (int l = 0; l <= labels; ++l)
    waves.push_back({unit(random), unit(random), unit(random), 3 * unit(random), 3 * unit(random)});
  return image_of(size, [&](int i, int j, int k) {
    int best = 0;
    double least = 1e9;
    for (int l = 0; l <= labels; ++l) {
      const auto& w = waves[static_cast<std::size_t>(l)];
      const double value = std::sin(w[0] * i + w[1] * j + w[3]) + std::sin(w[2] * k + w[0] * j + w[4]);
      if (value < least) {
        least = value;
        best = l;
      }
    }
    return best;
  });
}

/// Lines, sheets and single voxels of labels of their own.
inline Image thin_things() {
  return image_of({40, 24, 24}, [](int i, int j, int k) {
    if (j % 4 == 2 && k % 4 == 2 && i < 12) return i % 3 == 1 ? 1 + i / 3 + 4 * (j / 4) + 24 * (k / 4) : 0;
    if (i >= 14 && i < 26 && j % 3 == 0 && k % 5 == 0) return 200 + j / 3 + 8 * (k / 5);
    if (i >= 28 && i % 3 == 0) return 300 + i / 3;
    return 0;
  });
}

}  // namespace label_images
