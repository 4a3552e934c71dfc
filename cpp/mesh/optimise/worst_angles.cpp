#include "worst_angles.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "certet/domain.hpp"
#include "mesh/quality/tet_block.hpp"
#include "mesh/ranges.hpp"
#include "vector.hpp"

namespace certet::optimising {
namespace {

struct Extremes {
  double greatest = -1, least = 1;  ///< cos |cos|
};

/// Of one of the lattice's own tetrahedra, all of whose angles are 60° or 90°.
constexpr float structured = 0.25F;

/// Whether a tetrahedron between points of the lattice is one of its own: all its edges are
/// short ones or long ones.
bool is_structured(const TetCorners& corners) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const Coord3 by = corners[j] - corners[i];
      const std::int64_t x = by.x >> step_bits, y = by.y >> step_bits, z = by.z >> step_bits;
      const std::int64_t square = x * x + y * y + z * z;
      if (square != 3 && square != 4) return false;
    }
  return true;
}

/// Measures tetrahedra as many at once as is fast.
class Measurer {
 public:
  explicit Measurer(std::span<float> worst) : worst_(worst) {}

  void add(std::size_t tet, const TetCorners& corners) {
    block_.set(count_, {between(corners[0], corners[1]), between(corners[0], corners[2]),
                        between(corners[0], corners[3])});
    tets_[count_] = tet;
    if (++count_ == core::lanes) measure();
  }
  void add_structured(std::size_t tet) {
    worst_[tet] = structured;
    all_.greatest = std::max(all_.greatest, static_cast<double>(structured));
    all_.least = std::min(all_.least, 0.0);
  }
  Extremes result() {
    if (count_ > 0) measure();
    return all_;
  }

 private:
  void measure() {
    block_.repeat_first(count_);
    block_.compute();
    for (std::size_t i = 0; i < count_; ++i) {
      all_.greatest = std::max(all_.greatest, block_.greatest[i]);
      all_.least = std::min(all_.least, block_.least[i]);
      worst_[tets_[i]] = static_cast<float>(std::max(block_.greatest[i], -block_.least[i]));
    }
    count_ = 0;
  }

  std::span<float> worst_;
  Extremes all_;
  core::TetBlock block_;
  std::array<std::size_t, core::lanes> tets_;
  std::size_t count_ = 0;
};

bool are_on_lattice(const TetCorners& corners) {
  std::int32_t all = 0;
  for (const Coord3 corner : corners) all |= corner.x | corner.y | corner.z;
  return (all & (steps - 1)) == 0;
}

template <class Index>
Extremes measure(std::span<const Coord3> points, std::span<const Tet<Index>> tets,
                 std::span<float> worst) {
  Measurer measurer(worst);
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const Tet<Index>& tet = tets[t];
    const TetCorners corners{points[tet[0]], points[tet[1]], points[tet[2]], points[tet[3]]};
    if (are_on_lattice(corners) && is_structured(corners))
      measurer.add_structured(t);
    else
      measurer.add(t, corners);
  }
  return measurer.result();
}

template <class Index>
WorstAngles worst_of(std::span<const Coord3> points, std::span<const Tet<Index>> tets,
                     Context& context) {
  WorstAngles found{std::vector<float>(tets.size())};
  const auto parts = core::in_ranges(
      tets.size(), core::tets_per_task, Stage::emit, context,
      [&](std::size_t begin, std::size_t end) {
        return measure(points, tets.subspan(begin, end - begin),
                       std::span(found.of_tets).subspan(begin, end - begin));
      });
  Extremes all;
  for (const Extremes& part : parts) {
    all.greatest = std::max(all.greatest, part.greatest);
    all.least = std::min(all.least, part.least);
  }
  found.acute = std::max(all.greatest, 0.0);
  found.obtuse = std::max(-all.least, 0.0);
  return found;
}

}  // namespace

WorstAngles worst_angles(std::span<const Coord3> points,
                         std::span<const Tet<std::uint32_t>> tets, Context& context) {
  return worst_of(points, tets, context);
}

WorstAngles worst_angles(std::span<const Coord3> points,
                         std::span<const Tet<std::uint64_t>> tets, Context& context) {
  return worst_of(points, tets, context);
}

}  // namespace certet::optimising
