#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "cases.hpp"
#include "certet/bounded_function.hpp"
#include "certet/function_domain.hpp"
#include "certet/image.hpp"
#include "certet/materials_domain.hpp"
#include "certet/shape.hpp"
#include "domains.hpp"

namespace repeatability {
namespace {

using certet::Coord3;
using certet::Frame;
using certet::Image;
using certet::Lattice;
using certet::Sign;

constexpr Lattice around_origin(int half) {
  return {{-2 * half, -2 * half, -2 * half}, {2 * half, 2 * half, 2 * half}};
}

Shape positional(std::string name, domains::Positional domain, int half) {
  return {std::move(name), std::make_shared<domains::Positional>(std::move(domain)),
          around_origin(half), {}};
}

Shape level(std::string name, domains::Level level, int half) {
  return positional(std::move(name), domains::of_level(std::move(level)), half);
}

/// Cubes of three lattice units, inside and outside by turns.
Sign checkerboard(Coord3 p) {
  constexpr std::int32_t side = 3 * certet::steps;
  constexpr std::int32_t far = 1000 * side;  // makes the quotient positive
  const std::int32_t parity = (p.x + far) / side + (p.y + far) / side + (p.z + far) / side;
  return parity % 2 == 0 ? Sign::plus : Sign::minus;
}

/// Rotated and scaled by thirds, so that the world's numbers are not round.
Shape ellipsoid_in_the_world() {
  Frame frame{.origin = {1.0 / 3, -2.0 / 7, 0.1},
              .axes = {{{2.0 / 3, -1.0 / 3, 2.0 / 3},
                        {2.0 / 3, 2.0 / 3, -1.0 / 3},
                        {-1.0 / 3, 2.0 / 3, 2.0 / 3}}},
              .size = 0.07};
  const auto f = [](certet::Point3 p) {
    return p[0] * p[0] + p[1] * p[1] / 2 + p[2] * p[2] / 3 - 0.3;
  };
  return {"ellipsoid", std::make_shared<certet::FunctionDomain<decltype(f)>>(f, frame),
          around_origin(20), frame};
}

/// An image whose voxels are value(i, j, k).
template <class T, class Value>
Image image(std::array<std::int64_t, 3> size, certet::Point3 spacing, const Value& value) {
  certet::Buffer<T> voxels(static_cast<std::size_t>(size[0] * size[1] * size[2]));
  T* out = voxels.data();
  for (std::int64_t k = 0; k < size[2]; ++k)
    for (std::int64_t j = 0; j < size[1]; ++j)
      for (std::int64_t i = 0; i < size[0]; ++i) *out++ = static_cast<T>(value(i, j, k));
  Image made;
  made.name = "made here";
  made.size = size;
  made.spacing = spacing;
  made.voxels = std::move(voxels);
  return made;
}

Shape of_placed(std::string name, std::unique_ptr<certet::PlacedDomain> domain) {
  const Lattice lattice = domain->lattice();
  const Frame frame = domain->frame();
  return {std::move(name), std::move(domain), lattice, frame};
}

/// Labels that touch all six borders of the image, and corners of one another.
certet::Image crowded(const certet::Point3& spacing) {
  const auto value = [](std::int64_t i, std::int64_t j, std::int64_t k) {
    return (i * 7 + j * 5 + k * 3 + i * j) % 11 < 6 ? 1 + (i / 4 + j / 3 + k / 5) % 3 : 0;
  };
  return image<std::int16_t>({14, 12, 10}, spacing, value);
}

Shape labels(std::string name, bool walls_halfway) {
  return of_placed(std::move(name), certet::label_domain(crowded({1, 1.5, 2}), {},
                                                        {.walls_halfway = walls_halfway}));
}

/// The same with smooth surfaces: without a lattice point at the centre of each voxel and
/// with one, and of one label alone.
Shape smooth_labels(std::string name, const certet::Point3& spacing,
                    std::vector<certet::LabelRange> chosen) {
  return of_placed(std::move(name),
                  certet::interface_domain(crowded(spacing), std::move(chosen)));
}

Shape smooth_balls() {
  const auto value = [](std::int64_t i, std::int64_t j, std::int64_t k) {
    const auto square = [](std::int64_t n) { return n * n; };
    if (square(i - 9) + square(j - 8) + square(k - 8) < 20) return 2;
    return square(i - 12) + square(j - 11) + square(k - 9) < 80 ? 1 : 0;
  };
  return of_placed("smooth-balls",
                  certet::interface_domain(image<std::int16_t>({24, 22, 20}, {1, 1, 1}, value),
                                           {}, {}, {1.3}));
}

/// A level surface that runs out of the image.
Shape grayscale() {
  const auto value = [](std::int64_t i, std::int64_t j, std::int64_t k) {
    return (i - 6) * (i - 6) + 2 * (j - 5) * (j - 5) + (k - 1) * (k - 1) * 3;
  };
  return of_placed("grayscale", certet::level_domain(
                                   image<float>({13, 11, 9}, {0.7, 0.9, 1.1}, value), 40.5,
                                   {.size = 0.65}));
}

/// Solids in one another's way, the strongest neither the first nor the last.
Shape overlapping_solids() {
  return of_placed("overlapping-solids",
                   certet::materials_domain({{"ball", certet::shape_solid("sphere:1")},
                                             {"rod", certet::shape_solid("cylinder:0.3,2.5")},
                                             {"ring", certet::shape_solid("torus:0.8,0.3")}},
                                            {.size = 0.15}, {"rod"}));
}

/// Boxes whose common walls are planes of lattice points, and meet in a line of them.
Shape walls_on_the_lattice() {
  const auto box = [](certet::Point3 low, certet::Point3 high) {
    return certet::function_solid([](certet::Point3) { return -1.0; }, certet::Bounds{low, high});
  };
  return of_placed("walls-on-the-lattice",
                   certet::materials_domain({{"half", box({-1, -1, -1}, {0, 1, 1})},
                                             {"front", box({0, -1, -1}, {1, 0, 1})},
                                             {"back", box({0, 0, -1}, {1, 1, 1})}},
                                            {.size = 0.25}, {"half"}));
}

}  // namespace

std::vector<Shape> shapes() {
  std::vector<Shape> all;
  all.push_back(level("sphere", domains::sphere(0.3, -0.2, 0.1, 20.7), 14));
  all.push_back(level("torus", domains::torus(0, 0, 0, 20, 7.5), 18));
  all.push_back(level("sheet", domains::slab(1, 2, 3, 0.1, 1.6), 12));
  all.push_back(level("thick-sheet", domains::slab(3, -1, 1, 0.5, 3.1), 12));
  all.push_back(level("box-on-the-lattice", domains::box(-8, 8), 8));
  all.push_back(positional("checkerboard", domains::Positional(checkerboard), 10));
  all.push_back(positional("noise", domains::noise(1, 0), 10));
  all.push_back(positional("noise-with-zeros", domains::noise(2, 64), 10));
  all.push_back(positional("cuts-near-the-ends", domains::random_cuts(3, 16, {0, 1, 65534, 65535}), 9));
  all.push_back(positional("cuts-at-the-thresholds",
                           domains::random_cuts(4, 16, {18687, 18688, 26111, 26112, 39424}), 9));
  all.push_back(ellipsoid_in_the_world());
  all.push_back(labels("labels", true));
  all.push_back(labels("labels-near-walls", false));
  all.push_back(grayscale());
  all.push_back(smooth_labels("smooth-labels", {1, 1, 1}, {}));
  all.push_back(smooth_labels("smooth-labels-off-centres", {1, 1.5, 2}, {}));
  all.push_back(smooth_labels("smooth-label", {1, 1, 1}, {{2, 2}}));
  all.push_back(smooth_balls());
  all.push_back(overlapping_solids());
  all.push_back(walls_on_the_lattice());
  return all;
}

std::vector<Manner> manners() {
  using certet::Method;
  return {{"bisect-pieces", Method::embedded},
          {"bisect-angles", Method::angles},
          {"bisect-embedding", Method::embedding},
          {"midpoint", Method::midpoint},
          {"bisect-pieces-graded", Method::embedded, 3},
          {"midpoint-graded", Method::midpoint, 2},
          {"bisect-key", Method::key},
          {"bisect-key-graded", Method::key, 3}};
}

}  // namespace repeatability
