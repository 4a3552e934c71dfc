#pragma once
/// \file
/// What `certet check` tells of tetrahedra of ten nodes.

#include <optional>

#include "certet/curved_quality.hpp"
#include "certet/formats.hpp"
#include "json.hpp"
#include "table.hpp"

namespace certet::command {

/// Nothing of tetrahedra of four nodes.
inline std::optional<CurvedQuality> measure_curved(const FileMesh& mesh, Context& context) {
  if (mesh.middles.empty()) return std::nullopt;
  return certet::measure_curved(mesh.points, mesh.tets, mesh.middle_points, mesh.middles, context);
}

inline void add_curved(Lines& lines, const CurvedQuality& curved) {
  lines.add("order", "2: {} middle nodes, {} of them beside the middles of their edges",
            grouped(curved.nodes), grouped(curved.bent));
  lines.add("", "volume {:.9g}, Jacobian determinants at least {:.4f} of those of straight elements",
            curved.volume, curved.least_jacobian);
}

inline Json json_of(const CurvedQuality& curved) {
  return {{"middle_nodes", curved.nodes},
          {"bent", curved.bent},
          {"torn_edges", curved.torn_edges},
          {"shared_nodes", curved.shared_nodes},
          {"nonfinite_nodes", curved.nonfinite},
          {"bad_indices", curved.bad_indices},
          {"nonpositive", curved.nonpositive},
          {"least_jacobian", curved.least_jacobian},
          {"volume", curved.volume}};
}

}  // namespace certet::command
