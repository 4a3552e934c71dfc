#include "certet/quality.hpp"
#include "engine/corners.hpp"
#include "lattice_measurement.hpp"

namespace certet {
namespace {

template <class Index>
Quality lattice(std::span<const Coord3> points, std::uint64_t first_point,
                std::span<const Tet<Index>> tets) {
  core::LatticeMeasurement measurement(points);
  std::array<std::int64_t, core::batch_size> six_volumes;
  core::for_each_batch<Index>(
      points, first_point, tets, [&](std::size_t, std::span<const TetCorners> corners) {
        measurement.add(corners, std::span(six_volumes).first(corners.size()));
      });
  return measurement.result();
}

}  // namespace

Quality measure_lattice(std::span<const Coord3> points, std::uint64_t first_point,
                        std::span<const Tet<std::uint32_t>> tets) {
  return lattice(points, first_point, tets);
}

Quality measure_lattice(std::span<const Coord3> points, std::uint64_t first_point,
                        std::span<const Tet<std::uint64_t>> tets) {
  return lattice(points, first_point, tets);
}

}  // namespace certet
