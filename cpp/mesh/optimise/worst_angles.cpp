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

/// Which of many tetrahedra are the lattice's own, which have four short edges and two long ones.
/// Between points of the lattice no edge is shorter than those, and none is between those and one
/// whose square is 8, so that the sum of the squares tells.
class StructuredOnes {
 public:
  static constexpr std::size_t most = 64;

  void set(std::size_t i, const TetCorners& corners) {
    for (std::size_t e = 0; e < 3; ++e) {
      const Coord3 by = corners[e + 1] - corners[0];
      edges_[3 * e][i] = by.x;
      edges_[3 * e + 1][i] = by.y;
      edges_[3 * e + 2][i] = by.z;
    }
  }
  /// In a form that compilers vectorise.
  void find() {
    constexpr std::uint32_t sum_of_squares = 4 * 3 + 2 * 4;
    for (std::size_t i = 0; i < most; ++i) {
      std::int32_t parts = 0, parities = 0;
      for (std::size_t e = 0; e < 9; e += 3) {
        const std::int32_t x = edges_[e][i], y = edges_[e + 1][i], z = edges_[e + 2][i];
        parts |= x | y | z;
        parities |= (x ^ y) | (y ^ z);
      }
      std::uint32_t squares = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto along = [&](std::size_t e) {
          return static_cast<std::uint32_t>(edges_[3 * e + axis][i] >> step_bits);
        };
        const std::uint32_t u = along(0), v = along(1), w = along(2), sum = u + v + w;
        squares += 4 * (u * u + v * v + w * w) - sum * sum;
      }
      const std::int32_t off = (parts & (steps - 1)) | (parities & steps);
      are_[i] = static_cast<std::uint32_t>(off) | (squares ^ sum_of_squares);
    }
  }
  [[nodiscard]] bool is(std::size_t i) const { return are_[i] == 0; }

 private:
  std::array<std::array<std::int32_t, most>, 9> edges_{};
  std::array<std::uint32_t, most> are_{};
};

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
    any_structured_ = true;
  }
  Extremes result() {
    if (count_ > 0) measure();
    if (any_structured_)
      all_ = {std::max(all_.greatest, double{structured}), std::min(all_.least, 0.0)};
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
  bool any_structured_ = false;
  core::TetBlock block_;
  std::array<std::size_t, core::lanes> tets_;
  std::size_t count_ = 0;
};

template <class Index>
Extremes measure(std::span<const Coord3> points, std::span<const Tet<Index>> tets,
                 std::span<float> worst) {
  Measurer measurer(worst);
  StructuredOnes structured_ones;
  for (std::size_t begin = 0; begin < tets.size(); begin += StructuredOnes::most) {
    const std::size_t count = std::min(StructuredOnes::most, tets.size() - begin);
    const auto corners_of = [&](std::size_t i) {
      const auto& [a, b, c, d] = tets[begin + i];
      return TetCorners{points[a], points[b], points[c], points[d]};
    };
    for (std::size_t i = 0; i < count; ++i) structured_ones.set(i, corners_of(i));
    structured_ones.find();
    for (std::size_t i = 0; i < count; ++i)
      if (structured_ones.is(i)) measurer.add_structured(begin + i);
      else measurer.add(begin + i, corners_of(i));
  }
  return measurer.result();
}

template <class Index>
WorstAngles worst_of(std::span<const Coord3> points, std::span<const Tet<Index>> tets,
                     Context& context) {
  WorstAngles found{Buffer<float>(tets.size())};
  const auto parts = core::in_ranges(
      tets.size(), core::tets_per_task, Stage::emit, context,
      [&](std::size_t begin, std::size_t end) {
        return measure(points, tets.subspan(begin, end - begin),
                       std::span(found.of_tets.data() + begin, end - begin));
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
