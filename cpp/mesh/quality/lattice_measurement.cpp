#include "lattice_measurement.hpp"

#include <algorithm>

#include "certet/error.hpp"
#include "extremes.hpp"

namespace certet::core {
namespace {

[[noreturn]] void refuse(const char* sentence) { throw Error(ErrorCode::bad_input, sentence); }

void refuse_wide(const LatticeShape& shape) {
  if (shape.is_wide()) refuse("a tetrahedron is too wide to be measured exactly");
}

}  // namespace

LatticeMeasurement::LatticeMeasurement(std::span<const Coord3> points) {
  constexpr std::int32_t limit = coordinate_limit * steps;
  const auto far = [](std::int32_t c) { return c < -limit || c > limit; };
  for (const Coord3 p : points)
    if (far(p.x) || far(p.y) || far(p.z)) refuse("a point is outside the coordinate range");
}

void LatticeMeasurement::add_copies(std::span<const std::array<Coord3, 4>> tets,
                                    std::uint64_t copies, std::span<std::int64_t> six_volumes) {
  const auto measured = [this](const MeasuredShape& shape, std::uint64_t count) {
    measure(shape, count);
  };
  std::ranges::transform(tets, six_volumes.begin(), [&](const std::array<Coord3, 4>& corners) {
    return shapes_.add(LatticeShape(corners), copies, refuse_wide, measured);
  });
}

void LatticeMeasurement::measure(const MeasuredShape& shape, std::uint64_t copies) {
  block_.set(count_, shape.shape.exact());
  copies_[count_] = copies;
  exact_[count_] = shape.six_volume;
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
  shapes_.release_all([this](const MeasuredShape& shape, std::uint64_t copies) {
    measure(shape, copies);
  });
  flush();
  Quality quality = measurement_.result();
  quality.steps_volume = six_volumes_;
  quality.volume = long_edges_cubed(six_volumes_);
  return quality;
}

}  // namespace certet::core
