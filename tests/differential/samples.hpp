#pragma once
/// \file
/// Every sample of a lattice, against those of voxels.

#include <functional>
#include <string>

#include "certified.hpp"
#include "differences.hpp"
#include "engine/cuts.hpp"
#include "engine/sample.hpp"
#include "seed.hpp"

/// \param holds which voxels of the grid are inside
inline void expect_samples_of(const certified::VoxelGrid& grid,
                              const std::function<bool(certet::Coord3)>& holds,
                              const certet::Domain& domain, const certet::Lattice& lattice,
                              const certet::MethodFacts& method, Differences& differences) {
  using namespace certet;
  Context context;
  const auto planes = core::sample(domain, lattice, core::whole(lattice), method, context);
  for (const core::Grid g : core::grids)
    for (int k = 0; k < lattice.cells[2]; ++k)
      for (int j = 0; j < lattice.cells[1]; ++j)
        for (int i = 0; i < lattice.cells[0]; ++i) {
          const Coord3 point = core::lattice_point(lattice, {g, {}}, i, j, k);
          const bool plus = (planes.plus(g, j, k)[i >> 6] >> (i & 63) & 1) != 0;
          differences.expect(
              certified::voxel_sign(grid, holds, point) == (plus ? Sign::plus : Sign::minus),
              [&] { return "seed " + std::to_string(test_seed()); });
        }
}
