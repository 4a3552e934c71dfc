#include "certet/quality.hpp"
#include "cell_runs.hpp"
#include "engine/corners.hpp"
#include "lattice_measurement.hpp"

namespace certet {
namespace {

template <class Index>
Quality lattice(std::span<const Coord3> points, std::uint64_t first_point,
                std::span<const Tet<Index>> tets) {
  core::LatticeMeasurement measurement(points);
  std::array<std::int64_t, core::batch_size> six_volumes;
  const auto add = [&](std::size_t begin, std::size_t count, std::uint64_t copies) {
    core::for_each_batch<Index>(
        points, first_point, tets.subspan(begin, count),
        [&](std::size_t, std::span<const TetCorners> corners) {
          measurement.add_copies(corners, copies, std::span(six_volumes).first(corners.size()));
        });
  };
  core::CellRuns<Index>(points, first_point, tets)
      .for_each([&](std::size_t begin, std::size_t cells) { add(begin, core::cell_tet_count, cells); },
                [&](std::size_t begin, std::size_t count) { add(begin, count, 1); });
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
