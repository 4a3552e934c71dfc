#include <algorithm>
#include <cmath>

#include "certet/error.hpp"
#include "certet/quality.hpp"
#include "angle_bins.hpp"
#include "extremes.hpp"
#include "tet_block.hpp"

namespace certet {
namespace {

using quality::AngleBins;
using quality::CarefulTet;
using quality::Edges;
using quality::lanes;
using quality::TetBlock;

/// Beyond this cos |cos| the cosine tells angles apart no better than to
/// 1e-10 degrees: the careful way takes over.
constexpr double nearly_flat = 1 - 1e-8;

/// Sums up blocks; what is exact and needs no order is kept in `quality_`.
class Measurement {
 public:
  /// `positive` says of each of the first `count` lanes whether it is.
  void add(const TetBlock& block, std::size_t count,
           const std::array<bool, lanes>& positive);
  [[nodiscard]] Quality result();

 private:
  void add_angles(const TetBlock& block, std::size_t lane);
  void add_extremes(const std::array<double, 6>& signed_squared_cotangents);
  void add_careful(const CarefulTet& tet);

  Quality quality_;
  const AngleBins& bins_ = quality::angle_bins();
  // One histogram for each pair of faces: neighbouring tetrahedra are alike,
  // and counting in one place again and again would wait for memory.
  std::array<std::array<std::uint64_t, Quality::bins>, 6> histograms_{};
  double greatest_ = -1, least_ = 1;
};

void Measurement::add(const TetBlock& block, std::size_t count,
                      const std::array<bool, lanes>& positive) {
  std::array<std::uint64_t, lanes> counted{};
  for (std::size_t i = 0; i < count; ++i) {
    if (!positive[i])
      ++quality_.nonpositive;
    else if (!block.in_range(i))
      add_careful(CarefulTet(block.get(i)));
    else {
      add_angles(block, i);
      counted[i] = 1;
    }
  }
  for (std::size_t pair = 0; pair < histograms_.size(); ++pair)
    for (std::size_t i = 0; i < count; ++i)
      histograms_[pair][bins_.bin(block.signed_square[pair][i], block.cell[pair][i])] +=
          counted[i];
  quality_.tets += count;
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

void Measurement::add_careful(const CarefulTet& tet) {
  const auto values = tet.signed_squared_cotangents();
  add_extremes(values);
  for (const double value : values) {
    // cos² = cot² / (1 + cot²), and 1 where the cotangent overflowed.
    const double square = 1 - 1 / (1 + std::fabs(value));
    const double signed_square = std::copysign(square, value);
    ++quality_.histogram[bins_.bin(signed_square, AngleBins::cell(signed_square))];
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

/// The sum of the lanes that are finite, always in the same order.
double sum(quality::Lanes values) {
  for (double& value : values) value = std::isfinite(value) ? value : 0;
  for (std::size_t half = lanes / 2; half > 0; half /= 2)
    for (std::size_t i = 0; i < half; ++i) values[i] += values[i + half];
  return values[0];
}

/// Calls work(block of tets) for all tets, 64 at a time.
template <class Index, class Work>
void for_blocks(std::span<const Tet<Index>> tets, Work work) {
  for (std::size_t begin = 0; begin < tets.size(); begin += lanes)
    work(tets.subspan(begin, std::min(lanes, tets.size() - begin)));
}

/// A harmless tetrahedron for the lanes that a last block leaves free.
constexpr Edges filler{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

template <class Index>
Quality world(std::span<const Point3> points, std::uint64_t first_point,
              std::span<const Tet<Index>> tets) {
  Measurement measurement;
  TetBlock block;
  std::array<bool, lanes> positive{};
  double six_volumes = 0;
  const auto point = [&](Index index) -> const Point3& { return points[index - first_point]; };
  for_blocks(tets, [&](std::span<const Tet<Index>> part) {
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Point3& p = point(part[i][0]);
      const Point3& q = point(part[i][1]);
      const Point3& r = point(part[i][2]);
      const Point3& s = point(part[i][3]);
      block.set(i, {{q[0] - p[0], q[1] - p[1], q[2] - p[2]},
                    {r[0] - p[0], r[1] - p[1], r[2] - p[2]},
                    {s[0] - p[0], s[1] - p[1], s[2] - p[2]}});
    }
    for (std::size_t i = part.size(); i < lanes; ++i) block.set(i, filler);
    block.compute();
    for (std::size_t i = part.size(); i < lanes; ++i) block.six_volume[i] = 0;
    for (std::size_t i = 0; i < part.size(); ++i)
      positive[i] = block.in_range(i) ? block.six_volume[i] > 0
                                      : CarefulTet(block.get(i)).positive();
    measurement.add(block, part.size(), positive);
    six_volumes += sum(block.six_volume);
  });
  Quality quality = measurement.result();
  quality.volume = six_volumes / 6;
  return quality;
}

/// Edges along which all coordinates are smaller than 2^19 in magnitude have a
/// determinant smaller than 2^60.
constexpr std::int64_t edge_limit = std::int64_t{1} << 19;

struct LatticeEdge {
  std::int64_t x, y, z;

  LatticeEdge(Coord3 from, Coord3 to)
      : x(std::int64_t{to.x} - from.x), y(std::int64_t{to.y} - from.y),
        z(std::int64_t{to.z} - from.z) {}

  [[nodiscard]] Point3 exact() const {
    return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }
  /// Has a bit above the lowest 20 unless -2^19 <= x, y, z < 2^19.
  [[nodiscard]] std::uint64_t excess() const {
    const auto shifted = [](std::int64_t v) { return static_cast<std::uint64_t>(v + edge_limit); };
    return shifted(x) | shifted(y) | shifted(z);
  }
};

std::int64_t determinant(const LatticeEdge& a, const LatticeEdge& b, const LatticeEdge& c) {
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
         a.z * (b.x * c.y - b.y * c.x);
}

template <class Index>
Quality lattice(std::span<const Coord3> points, std::uint64_t first_point,
                std::span<const Tet<Index>> tets) {
  Measurement measurement;
  TetBlock block;
  std::array<bool, lanes> positive{};
  std::array<std::int64_t, lanes> exact{};
  WideSum six_volumes;
  const auto point = [&](Index index) { return points[index - first_point]; };
  for_blocks(tets, [&](std::span<const Tet<Index>> part) {
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Coord3 p = point(part[i][0]);
      const LatticeEdge a(p, point(part[i][1])), b(p, point(part[i][2])), c(p, point(part[i][3]));
      if ((a.excess() | b.excess() | c.excess()) >= 2 * std::uint64_t{edge_limit})
        throw Error(ErrorCode::bad_input, "a tetrahedron is too wide to be measured exactly");
      block.set(i, {a.exact(), b.exact(), c.exact()});
      exact[i] = determinant(a, b, c);
      six_volumes += exact[i];
    }
    for (std::size_t i = part.size(); i < lanes; ++i) block.set(i, filler);
    block.compute();
    for (std::size_t i = 0; i < part.size(); ++i) {
      block.six_volume[i] = static_cast<double>(exact[i]);
      positive[i] = exact[i] > 0;
    }
    measurement.add(block, part.size(), positive);
  });
  Quality quality = measurement.result();
  quality.steps_volume = six_volumes;
  quality.volume = quality::long_edges_cubed(six_volumes);
  return quality;
}

}  // namespace

Quality measure_world(std::span<const Point3> points, std::uint64_t first_point,
                      std::span<const Tet<std::uint32_t>> tets) {
  return world(points, first_point, tets);
}

Quality measure_world(std::span<const Point3> points, std::uint64_t first_point,
                      std::span<const Tet<std::uint64_t>> tets) {
  return world(points, first_point, tets);
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
