#pragma once
/// \file
/// What several ranks have found in their parts of a mesh, brought together.

#include <cstdint>
#include <vector>

#include "certet/ranks.hpp"
#include "certet/write_mesh.hpp"
#include "mesh/boundary.hpp"

namespace certet::pipeline {

/// Of the whole mesh, at every rank: sums in the order of ranks, which is that of layers.
inline void gather(Ranks& ranks, WrittenMesh& written) {
  struct Part {
    Quality lattice, world;
    std::uint64_t coincident_points, checksum, file_checksum;
  };
  const std::vector<Part> parts =
      gather_each(ranks, Part{written.lattice, written.world, written.coincident_points,
                              written.checksum, written.file_checksum});
  written = {};
  for (const Part& part : parts) {
    written.lattice += part.lattice;
    written.world += part.world;
    written.coincident_points += part.coincident_points;
    written.checksum += part.checksum;
    written.file_checksum += part.file_checksum;
  }
}

inline void gather(Ranks& ranks, core::RegionCounts& regions) {
  struct Part {
    std::int32_t label;
    std::uint64_t tets;
    WideSum six_volumes;
  };
  std::vector<Part> own;
  regions.visit([&own](std::int32_t label, std::uint64_t tets, const WideSum& six_volumes) {
    own.push_back({label, tets, six_volumes});
  });
  regions = {};
  for (const Part& part : gather_all(ranks, std::span<const Part>(own)))
    regions.add(part.label, part.tets, part.six_volumes);
}

}  // namespace certet::pipeline
