#include <algorithm>
#include <cmath>
#include <limits>

#include "certet/error.hpp"
#include "certet/quality.hpp"
#include "angle_bins.hpp"
#include "extremes.hpp"
#include "shape_counter.hpp"
#include "tet_block.hpp"

namespace certet {
namespace {

using quality::AngleBins;
using quality::CarefulTet;
using quality::Edges;
using quality::lanes;
using quality::LatticeEdge;
using quality::LatticeShape;
using quality::ShapeCounter;
using quality::TetBlock;

/// Beyond this cos |cos| the cosine tells angles apart no better than to
/// 1e-10 degrees: the careful way takes over.
constexpr double nearly_flat = 1 - 1e-8;

/// How many tetrahedra each lane stands for.
using Copies = std::array<std::uint64_t, lanes>;

/// Sums up blocks; what is exact and needs no order is kept in `quality_`.
class Measurement {
 public:
  explicit Measurement(Histogram histogram) : wants_histogram_(histogram == Histogram::counted) {}

  /// `block` has been computed; its lanes from `count` on repeat the first.
  /// `positive(lane)` tells whether a tetrahedron is.
  template <class Positive>
  void add(TetBlock& block, std::size_t count, const Copies& copies, const Positive& positive);
  [[nodiscard]] Quality result();

 private:
  void add_ordinary(const TetBlock& block);
  void add_angles(const TetBlock& block, std::size_t lane);
  void add_extremes(const std::array<double, 6>& signed_squared_cotangents);
  void add_careful(const CarefulTet& tet, std::uint64_t copies);
  void count_angles(TetBlock& block, std::size_t count, const Copies& counted);

  Quality quality_;
  bool wants_histogram_;
  const AngleBins& bins_ = quality::angle_bins();
  // One histogram for each pair of faces: neighbouring tetrahedra are alike,
  // and counting in one place again and again would wait for memory.
  std::array<std::array<std::uint64_t, Quality::bins>, 6> histograms_{};
  double greatest_ = -1, least_ = 1;
};

/// Whether all tetrahedra are positive, in range, and not nearly flat.
bool ordinary(const TetBlock& block) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < lanes; ++i) {
    const double volume = block.six_volume[i];
    // No branches, so that the loop vectorises.
    count += int{volume > 0} & int{volume <= std::numeric_limits<double>::max()} &
             int{block.least_face[i] > 1e-140} & int{block.greatest_face[i] < 1e140} &
             int{block.greatest[i] <= nearly_flat} & int{block.least[i] >= -nearly_flat};
  }
  return count == lanes;
}

template <class Positive>
void Measurement::add(TetBlock& block, std::size_t count, const Copies& copies,
                      const Positive& positive) {
  for (std::size_t i = 0; i < count; ++i) quality_.tets += copies[i];
  if (ordinary(block)) {
    add_ordinary(block);
    return count_angles(block, count, copies);
  }
  Copies counted{};
  for (std::size_t i = 0; i < count; ++i) {
    if (!positive(i))
      quality_.nonpositive += copies[i];
    else if (!block.in_range(i))
      add_careful(CarefulTet(block.get(i)), copies[i]);
    else {
      add_angles(block, i);
      counted[i] = copies[i];
    }
  }
  count_angles(block, count, counted);
}

/// The first of all lanes after folding the upper half onto the lower again and
/// again: always the same order, whatever the machine.
template <class Operation>
double folded(quality::Lanes values, Operation operation) {
  for (std::size_t half = lanes / 2; half > 0; half /= 2)
    for (std::size_t i = 0; i < half; ++i) values[i] = operation(values[i], values[i + half]);
  return values[0];
}

void Measurement::add_ordinary(const TetBlock& block) {
  const auto greater = [](double a, double b) { return a > b ? a : b; };
  const auto lesser = [](double a, double b) { return a < b ? a : b; };
  greatest_ = greater(greatest_, folded(block.greatest, greater));
  least_ = lesser(least_, folded(block.least, lesser));
}

void Measurement::count_angles(TetBlock& block, std::size_t count, const Copies& counted) {
  if (!wants_histogram_) return;
  block.find_cells();
  for (std::size_t pair = 0; pair < histograms_.size(); ++pair)
    for (std::size_t i = 0; i < count; ++i)
      histograms_[pair][bins_.bin(block.signed_square[pair][i], block.cell[pair][i])] +=
          counted[i];
}

void Measurement::add_angles(const TetBlock& block, std::size_t lane) {
  const double greatest = block.greatest[lane], least = block.least[lane];
  if (greatest > nearly_flat || least < -nearly_flat)
    return add_extremes(
        CarefulTet(block.get(lane), block.six_volume[lane]).signed_squared_cotangents());
  if (greatest > greatest_) greatest_ = greatest;
  if (least < least_) least_ = least;
}

void Measurement::add_extremes(const std::array<double, 6>& signed_squared_cotangents) {
  for (const double value : signed_squared_cotangents) {
    quality_.sharpest = std::max(quality_.sharpest, value);
    quality_.bluntest = std::min(quality_.bluntest, value);
  }
}

void Measurement::add_careful(const CarefulTet& tet, std::uint64_t copies) {
  const auto values = tet.signed_squared_cotangents();
  add_extremes(values);
  if (!wants_histogram_) return;
  for (const double value : values) {
    // cos² = cot² / (1 + cot²), and 1 where the cotangent overflowed.
    const double square = 1 - 1 / (1 + std::fabs(value));
    const double signed_square = std::copysign(square, value);
    quality_.histogram[bins_.bin(signed_square, AngleBins::cell(signed_square))] += copies;
  }
}

Quality Measurement::result() {
  for (const auto& histogram : histograms_)
    for (std::size_t bin = 0; bin < histogram.size(); ++bin)
      quality_.histogram[bin] += histogram[bin];
  // cos² / sin² grows with cos² in floating point too, so that the greatest
  // cosine gives the greatest cotangent, whatever else was measured with it.
  const auto cotangent = [](double signed_square) {
    return signed_square / (1 - std::fabs(signed_square));
  };
  if (greatest_ > -1) quality_.sharpest = std::max(quality_.sharpest, cotangent(greatest_));
  if (least_ < 1) quality_.bluntest = std::min(quality_.bluntest, cotangent(least_));
  quality::set_extremes(quality_);
  return quality_;
}

/// Copies of lanes that stand for one tetrahedron each.
constexpr Copies one_each = [] {
  Copies copies{};
  copies.fill(1);
  return copies;
}();

/// The sum of the lanes that are finite.
double sum(quality::Lanes values) {
  for (double& value : values) value = std::isfinite(value) ? value : 0;
  return folded(values, [](double a, double b) { return a + b; });
}

template <class Index>
Quality world(std::span<const Point3> points, std::uint64_t first_point,
              std::span<const Tet<Index>> tets, Histogram histogram) {
  Measurement measurement(histogram);
  TetBlock block;
  double six_volumes = 0;
  const auto point = [&](Index index) -> const Point3& { return points[index - first_point]; };
  const auto positive = [&block](std::size_t i) {
    return block.in_range(i) ? block.six_volume[i] > 0 : CarefulTet(block.get(i)).positive();
  };
  for (std::size_t begin = 0; begin < tets.size(); begin += lanes) {
    const std::size_t count = std::min(lanes, tets.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      const Tet<Index>& tet = tets[begin + i];
      const Point3& p = point(tet[0]);
      const Point3& q = point(tet[1]);
      const Point3& r = point(tet[2]);
      const Point3& s = point(tet[3]);
      block.set(i, {{q[0] - p[0], q[1] - p[1], q[2] - p[2]},
                    {r[0] - p[0], r[1] - p[1], r[2] - p[2]},
                    {s[0] - p[0], s[1] - p[1], s[2] - p[2]}});
    }
    block.repeat_first(count);
    block.compute();
    measurement.add(block, count, one_each, positive);
    for (std::size_t i = count; i < lanes; ++i) block.six_volume[i] = 0;
    six_volumes += sum(block.six_volume);
  }
  Quality quality = measurement.result();
  quality.volume = six_volumes / 6;
  return quality;
}

/// Edges along which all coordinates are smaller than 2^19 in magnitude have a
/// determinant smaller than 2^60.
constexpr std::int64_t edge_limit = std::int64_t{1} << 19;

void refuse_wide(const LatticeShape& shape) {
  const auto wide = [](std::int64_t v) { return v < -edge_limit || v >= edge_limit; };
  for (const LatticeEdge& edge : {shape.a, shape.b, shape.c})
    if (wide(edge.x) || wide(edge.y) || wide(edge.z))
      throw Error(ErrorCode::bad_input, "a tetrahedron is too wide to be measured exactly");
}

/// Measures every shape once for all its copies.
class LatticeMeasurement {
 public:
  void add(const LatticeShape& tet) {
    shapes_.add(tet, refuse_wide, [this](const LatticeShape& shape, std::uint64_t copies) {
      measure(shape, copies);
    });
  }
  [[nodiscard]] Quality result();

 private:
  void measure(const LatticeShape& shape, std::uint64_t copies);
  void flush();

  ShapeCounter shapes_;
  Measurement measurement_{Histogram::counted};
  WideSum six_volumes_;
  std::size_t count_ = 0;  ///< of shapes in the block
  TetBlock block_;
  Copies copies_{};
  std::array<std::int64_t, lanes> exact_{};  ///< determinants
};

void LatticeMeasurement::measure(const LatticeShape& shape, std::uint64_t copies) {
  block_.set(count_, shape.exact());
  copies_[count_] = copies;
  exact_[count_] = shape.determinant();
  six_volumes_ += WideSum::product(exact_[count_], copies);
  if (++count_ == lanes) flush();
}

void LatticeMeasurement::flush() {
  if (count_ == 0) return;
  block_.repeat_first(count_);
  std::fill(exact_.begin() + static_cast<std::ptrdiff_t>(count_), exact_.end(), exact_[0]);
  block_.compute();
  for (std::size_t i = 0; i < lanes; ++i) block_.six_volume[i] = static_cast<double>(exact_[i]);
  measurement_.add(block_, count_, copies_, [this](std::size_t i) { return exact_[i] > 0; });
  count_ = 0;
}

Quality LatticeMeasurement::result() {
  shapes_.release_all([this](const LatticeShape& shape, std::uint64_t copies) {
    measure(shape, copies);
  });
  flush();
  Quality quality = measurement_.result();
  quality.steps_volume = six_volumes_;
  quality.volume = quality::long_edges_cubed(six_volumes_);
  return quality;
}

template <class Index>
Quality lattice(std::span<const Coord3> points, std::uint64_t first_point,
                std::span<const Tet<Index>> tets) {
  LatticeMeasurement measurement;
  const auto point = [&](Index index) { return points[index - first_point]; };
  for (const Tet<Index>& tet : tets) {
    const Coord3 p = point(tet[0]);
    measurement.add({{p, point(tet[1])}, {p, point(tet[2])}, {p, point(tet[3])}});
  }
  return measurement.result();
}

}  // namespace

Quality measure_world(std::span<const Point3> points, std::uint64_t first_point,
                      std::span<const Tet<std::uint32_t>> tets, Histogram histogram) {
  return world(points, first_point, tets, histogram);
}

Quality measure_world(std::span<const Point3> points, std::uint64_t first_point,
                      std::span<const Tet<std::uint64_t>> tets, Histogram histogram) {
  return world(points, first_point, tets, histogram);
}

Quality measure_lattice(std::span<const Coord3> points, std::uint64_t first_point,
                        std::span<const Tet<std::uint32_t>> tets) {
  return lattice(points, first_point, tets);
}

Quality measure_lattice(std::span<const Coord3> points, std::uint64_t first_point,
                        std::span<const Tet<std::uint64_t>> tets) {
  return lattice(points, first_point, tets);
}

}  // namespace certet
