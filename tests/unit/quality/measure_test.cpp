/// Angles and volumes of tetrahedra that are known, and of random ones against
/// a plain computation.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "certet/error.hpp"
#include "certet/quality.hpp"
#include "certet/lattice/structured_tet.hpp"
#include "same_quality.hpp"

namespace certet {
namespace {

using Tet32 = Tet<std::uint32_t>;
using Tet64 = Tet<std::uint64_t>;

constexpr double degrees = 180 / std::numbers::pi;

/// Tetrahedra that share no points.
template <class Point>
struct Soup {
  std::vector<Point> points;
  std::vector<Tet32> tets;

  void add(const std::array<Point, 4>& tet) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), tet.begin(), tet.end());
    tets.push_back({first, first + 1, first + 2, first + 3});
  }
};

Quality measure(const Soup<Point3>& soup) {
  return measure_world(soup.points, 0, std::span<const Tet32>(soup.tets));
}
Quality measure(const Soup<Coord3>& soup) {
  return measure_lattice(soup.points, 0, std::span<const Tet32>(soup.tets));
}

template <class Point>
Quality measure_one(const std::array<Point, 4>& tet) {
  Soup<Point> soup;
  soup.add(tet);
  return measure(soup);
}

using Real = long double;
using Vector = std::array<Real, 3>;

Vector between(const Point3& a, const Point3& b) {
  return {Real{b[0]} - a[0], Real{b[1]} - a[1], Real{b[2]} - a[2]};
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The six angles by the definition, in degrees.
std::array<double, 6> plain_angles(const std::array<Point3, 4>& p) {
  constexpr std::size_t edges[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2},
                               {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};
  std::array<double, 6> angles;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto [a, b, c, d] = edges[i];
    const Vector e = between(p[a], p[b]);
    const Vector m = cross(e, between(p[a], p[c])), n = cross(e, between(p[a], p[d]));
    const Vector sine = cross(m, n);
    angles[i] = static_cast<double>(std::atan2(std::sqrt(dot(sine, sine)), dot(m, n))) * degrees;
  }
  return angles;
}

double plain_volume(const std::array<Point3, 4>& p) {
  return static_cast<double>(
      dot(between(p[0], p[1]), cross(between(p[0], p[2]), between(p[0], p[3]))) / 6);
}

/// A random tetrahedron with positive volume.
std::array<Point3, 4> random_tet(std::mt19937_64& random, double scale = 1) {
  std::uniform_real_distribution<double> coordinate(-scale, scale);
  std::array<Point3, 4> tet;
  for (Point3& p : tet) p = {coordinate(random), coordinate(random), coordinate(random)};
  if (plain_volume(tet) < 0) std::swap(tet[2], tet[3]);
  return tet;
}

constexpr std::array<Point3, 4> regular{
    {{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}};

TEST(Measure, RegularTetrahedron) {
  const Quality quality = measure_one(regular);
  const double angle = std::acos(1.0 / 3) * degrees;
  EXPECT_EQ(quality.tets, 1u);
  EXPECT_EQ(quality.nonpositive, 0u);
  EXPECT_NEAR(quality.min_dihedral, angle, 1e-12);
  EXPECT_NEAR(quality.max_dihedral, angle, 1e-12);
  EXPECT_EQ(quality.histogram[14], 6u);
  EXPECT_NEAR(quality.volume, 8.0 / 3, 1e-12);
}

TEST(Measure, LatticeTetrahedraHaveSixtyAndNinetyDegrees) {
  for (const StructuredTetShape& shape : structured_tet_table) {
    std::array<Coord3, 4> tet = shape.vertices;
    for (Coord3& p : tet) p = steps * p;
    if (!shape.right_handed) std::swap(tet[2], tet[3]);
    const Quality quality = measure_one(tet);
    EXPECT_EQ(quality.nonpositive, 0u);
    EXPECT_NEAR(quality.min_dihedral, 60, 1e-12);
    EXPECT_NEAR(quality.max_dihedral, 90, 1e-12);
    // On the edges of bins, where only exact numbers tell them apart.
    EXPECT_EQ(quality.histogram[12], 4u);
    EXPECT_EQ(quality.histogram[18], 2u);
    EXPECT_EQ(quality.volume, 1.0 / 12);
    std::swap(tet[0], tet[1]);
    const Quality mirrored = measure_one(tet);
    EXPECT_EQ(mirrored.nonpositive, 1u);
    EXPECT_EQ(mirrored.volume, -1.0 / 12);
    EXPECT_EQ(mirrored.min_dihedral, 180.0);
    EXPECT_EQ(mirrored.max_dihedral, 0.0);
    EXPECT_EQ(mirrored.histogram, Quality{}.histogram);
  }
}

TEST(Measure, CornersOfACubeHaveTheirAnglesOnEdgesOfBins) {
  // 90 degrees three times; the others are acos(1/sqrt 3).
  const Quality quality = measure_one<Point3>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  EXPECT_EQ(quality.histogram[18], 3u);
  EXPECT_EQ(quality.histogram[10], 3u);
  // A sixth of the cube has 45, 60 and 90 degrees.
  const Quality sixth = measure_one<Point3>({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}});
  EXPECT_EQ(sixth.histogram[9], 2u);
  EXPECT_EQ(sixth.histogram[12], 1u);
  EXPECT_EQ(sixth.histogram[18], 3u);
}

TEST(Measure, AgreesWithThePlainComputation) {
  constexpr std::uint64_t seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  Soup<Point3> soup;
  double least = 180, greatest = 0, volume = 0;
  std::array<std::uint64_t, Quality::bins> histogram{};
  for (int i = 0; i < 5000; ++i) {
    const std::array<Point3, 4> tet = random_tet(random);
    soup.add(tet);
    volume += plain_volume(tet);
    for (const double angle : plain_angles(tet)) {
      least = std::min(least, angle);
      greatest = std::max(greatest, angle);
      ++histogram[static_cast<std::size_t>(angle / 5)];
    }
    const Quality one = measure_one(tet);
    const auto angles = plain_angles(tet);
    // A random tetrahedron can be so flat that its volume is little known.
    const double tolerance = 1e-11 / std::min(1.0, 1e3 * plain_volume(tet));
    ASSERT_NEAR(one.min_dihedral, *std::ranges::min_element(angles), tolerance);
    ASSERT_NEAR(one.max_dihedral, *std::ranges::max_element(angles), tolerance);
  }
  const Quality quality = measure(soup);
  EXPECT_EQ(quality.tets, 5000u);
  EXPECT_EQ(quality.nonpositive, 0u);
  EXPECT_EQ(quality.histogram, histogram);
  EXPECT_NEAR(quality.min_dihedral, least, 1e-9);
  EXPECT_NEAR(quality.max_dihedral, greatest, 1e-9);
  EXPECT_NEAR(quality.volume, volume, 1e-9);
}

/// Two crossing edges, 2 h apart: the flatter, the sharper.
constexpr std::array<Point3, 4> sliver(double h) {
  return {{{1, 0, h}, {-1, 0, h}, {0, 1, -h}, {0, -1, -h}}};
}

TEST(Measure, SliversKeepTheirAngles) {
  for (double h = 0.5; h > 1e-9; h /= 3) {
    const Quality quality = measure_one(sliver(h));
    const auto plain = plain_angles(sliver(h));
    ASSERT_EQ(quality.nonpositive, 0u) << h;
    ASSERT_NEAR(quality.max_dihedral, *std::ranges::max_element(plain), 1e-9) << h;
    ASSERT_NEAR(quality.min_dihedral / *std::ranges::min_element(plain), 1, 1e-7) << h;
    ASSERT_NEAR(quality.min_dihedral, *std::ranges::min_element(plain), 1e-9) << h;
  }
}

TEST(Measure, NegativeAndFlatTetrahedraAreCounted) {
  Soup<Point3> soup;
  soup.add(regular);
  soup.add({regular[1], regular[0], regular[2], regular[3]});
  soup.add({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}});
  soup.add({{{5, 5, 5}, {5, 5, 5}, {5, 5, 5}, {5, 5, 5}}});
  const Quality quality = measure(soup);
  EXPECT_EQ(quality.tets, 4u);
  EXPECT_EQ(quality.nonpositive, 3u);
  EXPECT_EQ(quality.histogram[14], 6u);
  EXPECT_NEAR(quality.volume, 0, 1e-15);
}

TEST(Measure, PointsThatAreNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t vertex = 0; vertex < 4; ++vertex)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const double bad : {infinity, -infinity, nan}) {
        std::array<Point3, 4> tet = regular;
        tet[vertex][axis] = bad;
        Soup<Point3> soup;
        soup.add(regular);
        soup.add(tet);
        const Quality quality = measure(soup);
        EXPECT_EQ(quality.nonpositive, 1u);
        EXPECT_EQ(quality.histogram[14], 6u);
        EXPECT_NEAR(quality.volume, 8.0 / 3, 1e-12);
      }
}

TEST(Measure, SizeDoesNotMatter) {
  std::mt19937_64 random(12);
  for (int i = 0; i < 50; ++i) {
    const std::array<Point3, 4> tet = random_tet(random);
    const Quality quality = measure_one(tet);
    for (const int exponent : {-330, -250, -60, 60, 250, 330}) {
      std::array<Point3, 4> scaled = tet;
      for (Point3& p : scaled)
        for (double& c : p) c = std::scalbn(c, exponent);
      const Quality other = measure_one(scaled);
      ASSERT_EQ(other.nonpositive, 0u) << exponent;
      ASSERT_EQ(other.histogram, quality.histogram) << exponent;
      ASSERT_NEAR(other.min_dihedral, quality.min_dihedral, 1e-9) << exponent;
      ASSERT_NEAR(other.max_dihedral, quality.max_dihedral, 1e-9) << exponent;
    }
  }
}

/// Three edges with determinant 1 and coordinates of up to 18 bits: the product
/// of triangular matrices with ones in their diagonals.
std::array<Coord3, 4> needle(std::mt19937_64& random) {
  std::uniform_int_distribution<std::int32_t> entry(-300, 300);
  const std::int32_t l10 = entry(random), l20 = entry(random), l21 = entry(random);
  const std::int32_t u01 = entry(random), u02 = entry(random), u12 = entry(random);
  const Coord3 a{1, u01, u02};
  const Coord3 b = l10 * a + Coord3{0, 1, u12};
  const Coord3 c = l20 * a + l21 * Coord3{0, 1, u12} + Coord3{0, 0, 1};
  const Coord3 origin{-2'000'000'000, 1'500'000'000, 7};
  return {{origin, origin + a, origin + b, origin + c}};
}

TEST(MeasureLattice, OrientationIsExact) {
  std::mt19937_64 random(13);
  for (int i = 0; i < 1000; ++i) {
    std::array<Coord3, 4> tet = needle(random);
    const Quality positive = measure_one(tet);
    ASSERT_EQ(positive.nonpositive, 0u);
    ASSERT_EQ(positive.steps_volume, (WideSum{1, 0}));
    std::array<Point3, 4> same{};
    for (std::size_t v = 0; v < 4; ++v) {
      const Coord3 p = tet[v] - tet[0];
      same[v] = {double{1} * p.x, double{1} * p.y, double{1} * p.z};
    }
    const auto angles = plain_angles(same);
    ASSERT_NEAR(positive.min_dihedral, *std::ranges::min_element(angles), 1e-9);
    ASSERT_NEAR(positive.max_dihedral, *std::ranges::max_element(angles), 1e-9);

    std::swap(tet[1], tet[3]);
    const Quality negative = measure_one(tet);
    ASSERT_EQ(negative.nonpositive, 1u);
    ASSERT_EQ(negative.steps_volume.value(), -1.0);
    tet[3] = tet[1] + (tet[2] - tet[0]);
    const Quality flat = measure_one(tet);
    ASSERT_EQ(flat.nonpositive, 1u);
    ASSERT_EQ(flat.steps_volume, WideSum{});
  }
}

TEST(MeasureLattice, RefusesWhatItCannotMeasureExactly) {
  const auto tet = [](std::int32_t width) {
    return std::array<Coord3, 4>{{{0, 0, 0}, {width, 0, 0}, {0, width, 0}, {0, 0, width}}};
  };
  constexpr std::int32_t limit = 1 << 20;
  EXPECT_EQ(measure_one(tet(limit)).tets, 1u);
  for (const std::int32_t width : {limit + 1, std::numeric_limits<std::int32_t>::max()})
    try {
      measure_one(tet(width));
      ADD_FAILURE() << "a tetrahedron of width " << width << " was measured";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_input);
    }
}

/// Measures a soup in parts of random sizes, and adds them in random order.
template <class Point, class Measure>
Quality in_parts(const Soup<Point>& soup, std::mt19937_64& random, Measure measure_part) {
  std::vector<Quality> parts;
  std::uniform_int_distribution<std::size_t> size(1, 200);
  for (std::size_t begin = 0; begin < soup.tets.size();) {
    const std::size_t count = std::min(size(random), soup.tets.size() - begin);
    parts.push_back(measure_part(std::span<const Tet32>(soup.tets).subspan(begin, count)));
    begin += count;
  }
  std::ranges::shuffle(parts, random);
  Quality sum;
  for (const Quality& part : parts) sum += part;
  return sum;
}

TEST(Measure, PartsAddUpToTheWhole) {
  std::mt19937_64 random(14);
  Soup<Point3> soup;
  for (int i = 0; i < 3000; ++i) soup.add(random_tet(random));
  for (const double h : {1e-3, 1e-5, 1e-7, 2e-7}) soup.add(sliver(h));
  soup.add({regular[1], regular[0], regular[2], regular[3]});
  const Quality whole = measure(soup);
  for (int i = 0; i < 5; ++i) {
    const Quality sum = in_parts(soup, random, [&](std::span<const Tet32> tets) {
      return measure_world(soup.points, 0, tets);
    });
    expect_same(whole, sum);
    EXPECT_NEAR(whole.volume, sum.volume, 1e-12 * whole.volume);
  }
}

TEST(MeasureLattice, PartsAddUpToTheWholeExactly) {
  std::mt19937_64 random(15);
  std::uniform_int_distribution<std::int32_t> coordinate(0, (1 << 19) - 1);
  Soup<Coord3> soup;
  for (int i = 0; i < 3000; ++i) {
    std::array<Coord3, 4> tet;
    for (Coord3& p : tet) p = {coordinate(random), coordinate(random), coordinate(random)};
    soup.add(tet);
    soup.add(needle(random));
  }
  const Quality whole = measure(soup);
  EXPECT_GT(whole.nonpositive, 1000u);
  for (int i = 0; i < 5; ++i) {
    const Quality sum = in_parts(soup, random, [&](std::span<const Tet32> tets) {
      return measure_lattice(soup.points, 0, tets);
    });
    expect_same(whole, sum);
    EXPECT_EQ(whole.volume, sum.volume);
  }
}

TEST(MeasureLattice, ShapesThatRepeatCountEachTime) {
  constexpr std::uint64_t seed = 17;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<int> copies(1, 4);
  std::uniform_int_distribution<std::int32_t> place(-1000, 1000);
  // More shapes than are remembered at a time; some are flat or inverted.
  Soup<Coord3> soup;
  Quality expected;
  for (int i = 0; i < 3000; ++i) {
    std::array<Coord3, 4> shape = needle(random);
    if (i % 5 == 0) std::swap(shape[1], shape[2]);
    if (i % 7 == 0) shape[3] = shape[2];
    const Quality one = measure_one(shape);
    for (int n = copies(random); n > 0; --n) {
      const Coord3 to{place(random), place(random), place(random)};
      soup.add({{shape[0] + to, shape[1] + to, shape[2] + to, shape[3] + to}});
      expected += one;
    }
  }
  std::ranges::shuffle(soup.tets, random);
  const Quality quality = measure(soup);
  expect_same(quality, expected);
  EXPECT_GT(quality.nonpositive, 100u);
  EXPECT_EQ(quality.volume, expected.volume);
}

TEST(Measure, WithoutHistogramTheRestIsTheSame) {
  std::mt19937_64 random(18);
  Soup<Point3> soup;
  for (int i = 0; i < 1000; ++i) soup.add(random_tet(random));
  for (const double h : {1e-3, 1e-7, 0.0}) soup.add(sliver(h));
  soup.add(random_tet(random, 1e-100));
  Quality whole = measure(soup);
  const Quality rest =
      measure_world(soup.points, 0, std::span<const Tet32>(soup.tets), Histogram::empty);
  EXPECT_EQ(rest.histogram, Quality{}.histogram);
  EXPECT_EQ(whole.volume, rest.volume);
  whole.histogram = {};
  expect_same(whole, rest);
}

TEST(Measure, IndicesOfBothWidthsAndAnyFirstPoint) {
  std::mt19937_64 random(16);
  constexpr std::uint64_t first = 5'000'000'000;
  Soup<Point3> soup;
  for (int i = 0; i < 100; ++i) soup.add(random_tet(random));
  std::vector<Tet64> moved;
  for (const Tet32& t : soup.tets)
    moved.push_back({first + t[0], first + t[1], first + t[2], first + t[3]});
  const Quality quality = measure(soup);
  const Quality other = measure_world(soup.points, first, std::span<const Tet64>(moved));
  expect_same(quality, other);
  EXPECT_EQ(quality.volume, other.volume);
}

TEST(Measure, AllButTheFirstOfManyAreMeasuredToo) {
  // One odd tetrahedron in each possible lane, and behind the last full block.
  for (std::size_t odd = 0; odd < 70; ++odd) {
    Soup<Point3> soup;
    for (std::size_t i = 0; i < 70; ++i)
      soup.add(i == odd ? sliver(0.1) : regular);
    const Quality quality = measure(soup);
    const Quality one = measure_one(sliver(0.1));
    EXPECT_EQ(quality.min_dihedral, one.min_dihedral);
    EXPECT_EQ(quality.max_dihedral, one.max_dihedral);
    EXPECT_EQ(quality.histogram[14], 69u * 6);
  }
}

}  // namespace
}  // namespace certet
