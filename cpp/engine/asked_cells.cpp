#include "asked_cells.hpp"

#include <algorithm>
#include <span>

#include "layer_loop.hpp"

namespace certet::core {
namespace {

/// The most levels of the cells of a row of level 0, each as it is at the centre.
class MostLevels {
 public:
  MostLevels(const SignPlanes& planes, const Lattice& lattice, const Grading& grading)
      : planes_(planes), lattice_(lattice), grading_(grading) {}

  void row(int j, int k, std::span<std::int32_t> most) const {
    std::ranges::fill(most, grading_.levels);
    if (grading_.at_points) {
      grading_.at_points(lattice_.origin + Coord3{1, 2 * j + 1, 2 * k + 1}, most);
      for (std::int32_t& levels : most) levels = std::clamp(levels, 0, grading_.levels);
    }
    if (grading_.of_materials.empty()) return;
    const MaterialPlanes* const materials = planes_.materials();
    for (std::size_t i = 0; i < most.size(); ++i) {
      const Material material =
          materials == nullptr ? 1 : materials->at(odd, static_cast<int>(i), j, k);
      most[i] = std::min(most[i], of_material(material));
    }
  }

 private:
  [[nodiscard]] std::int32_t of_material(Material material) const {
    const auto n = static_cast<std::size_t>(material) - 1;  // of the outside none
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
                                   const Grading& grading, Context& context) {
  if (grading.of_materials.empty() && !grading.at_points) return {};
  std::vector<CellPlane> asked(static_cast<std::size_t>(grading.levels),
                               CellPlane(LevelGrid(lattice)));
  const MostLevels most(planes, lattice, grading);
  for_each_layer(context, Stage::count, whole(lattice), [&](std::int32_t k) {
    std::vector<std::int32_t> levels(static_cast<std::size_t>(lattice.cells[0]));
    for (int j = 0; j < lattice.cells[1]; ++j) {
      most.row(j, k, levels);
      for (int level = 0; level < grading.levels; ++level) {
        std::uint64_t* const row = asked[static_cast<std::size_t>(level)].words(j, k);
        for (int i = 0; i < lattice.cells[0]; ++i)
          if (levels[static_cast<std::size_t>(i)] > level)
            row[i >> 6] &= ~(std::uint64_t{1} << (i & 63));
      }
    }
  });
  for (int level = 1; level < grading.levels; ++level)
    for (int step = 0; step < level; ++step) {
      CellPlane& cells = asked[static_cast<std::size_t>(level)];
      cells = around(cells, context);
    }
  return asked;
}

}  // namespace certet::core
