#include "asked_cells.hpp"

#include <algorithm>
#include <span>

#include "layer_loop.hpp"
#include "row_ranks.hpp"

namespace certet::core {
namespace {

/// The cells of a layer that do not exist, and so may be filled by larger ones.
std::vector<Coord3> free_cells(const CellPlane& existing, int k) {
  std::vector<Coord3> cells;
  const LevelGrid& grid = existing.grid();
  for (int j = 0; j < grid.cells[1]; ++j)
    for (int w = 0; w < grid.words(); ++w)
      for_each_bit(~existing.words(j, k)[w],
                   [&](int b) { cells.push_back({64 * w + b, j, k}); });
  return cells;
}

/// The most levels of cells of level 0, as each is at its centre.
class MostLevels {
 public:
  MostLevels(const SignPlanes& planes, const Lattice& lattice, const Grading& grading)
      : planes_(planes), lattice_(lattice), grading_(grading) {}

  [[nodiscard]] std::vector<std::int32_t> at(std::span<const Coord3> cells) const {
    std::vector<std::int32_t> most(cells.size(), grading_.levels);
    if (grading_.at_points && !cells.empty()) {
      std::vector<Coord3> centres(cells.size());
      std::ranges::transform(cells, centres.begin(), [this](Coord3 c) {
        return lattice_.origin + Coord3{2 * c.x + 1, 2 * c.y + 1, 2 * c.z + 1};
      });
      grading_.at_points(centres, most);
    }
    for (std::size_t n = 0; n < cells.size(); ++n)
      most[n] = std::clamp(std::min(most[n], of_material(cells[n])), 0, grading_.levels);
    return most;
  }

 private:
  [[nodiscard]] std::int32_t of_material(Coord3 cell) const {
    const MaterialPlanes* const materials = planes_.materials();
    const Material material = materials == nullptr ? 1 : materials->at(odd, cell.x, cell.y, cell.z);
    const auto n = static_cast<std::size_t>(material) - 1;
    return n < grading_.of_materials.size() ? grading_.of_materials[n] : grading_.levels;
  }

  const SignPlanes& planes_;
  const Lattice& lattice_;
  const Grading& grading_;
};

/// The cells a level above that any of the given ones lie in.
CellPlane around(const CellPlane& children, Context& context) {
  const LevelGrid& fine = children.grid();
  CellPlane parents(fine.coarser());
  for_each_layer(context, Stage::count, {0, parents.grid().cells[2]}, [&](std::int32_t k) {
    for (int j = 0; j < parents.grid().cells[1]; ++j)
      for (int w = 0; w < parents.grid().words(); ++w) {
        std::uint64_t any = 0;
        for (const int z : {0, 1})
          for (const int y : {0, 1}) {
            const BitRow row =
                children.row(2 * j - fine.is_upper(1) + y, 2 * k - fine.is_upper(2) + z);
            for (const int x : {0, 1}) {
              const int shift = x - fine.is_upper(0);
              any |= every_second(row.shifted(2 * w, shift), row.shifted(2 * w + 1, shift));
            }
          }
        parents.words(j, k)[w] = any;
      }
  });
  return parents;
}

}  // namespace

std::vector<CellPlane> asked_cells(const SignPlanes& planes, const Lattice& lattice,
                                   const CellPlane& existing, const Grading& grading,
                                   Context& context) {
  if (grading.of_materials.empty() && !grading.at_points) return {};
  std::vector<CellPlane> asked(static_cast<std::size_t>(grading.levels), existing);
  const MostLevels most(planes, lattice, grading);
  for_each_layer(context, Stage::count, whole(lattice), [&](std::int32_t k) {
    const std::vector<Coord3> cells = free_cells(existing, k);
    const std::vector<std::int32_t> levels = most.at(cells);
    for (std::size_t n = 0; n < cells.size(); ++n)
      for (int level = levels[n]; level < grading.levels; ++level)
        asked[static_cast<std::size_t>(level)].words(cells[n].y, k)[cells[n].x >> 6] |=
            std::uint64_t{1} << (cells[n].x & 63);
  });
  for (int level = 1; level < grading.levels; ++level)
    for (int step = 0; step < level; ++step) {
      CellPlane& cells = asked[static_cast<std::size_t>(level)];
      cells = around(cells, context);
    }
  return asked;
}

}  // namespace certet::core
