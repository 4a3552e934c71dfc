#pragma once
/// \file
/// What a `certet.Mesh` of Python holds.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certet/buffer.hpp"
#include "certet/curve.hpp"
#include "certet/features.hpp"
#include "certet/mesh.hpp"
#include "certet/optimise.hpp"
#include "certet/warp_figures.hpp"

namespace certet::python {

/// The middle nodes of a mesh of tetrahedra of ten nodes.
struct PythonMiddles {
  MiddleNodes nodes;
  std::vector<Point3> points;  ///< in the world
  std::vector<std::array<std::uint64_t, 6>> of_tets;  ///< numbers in `points`
  std::optional<CurveFigures> curved;  ///< if they are on the surface
};

/// Where middle nodes are, and whose.
PythonMiddles placed(const Mesh& mesh, MiddleNodes nodes, std::optional<CurveFigures> curved);

/// Pieces that were not to stay.
struct DroppedPieces {
  std::uint64_t pieces = 0, tets = 0;
  double volume = 0;  ///< world units cubed
};

/// A finished mesh; arrays handed out share its memory.
struct PythonMesh {
  Mesh mesh;
  Buffer<Point3> world;  ///< its points
  std::vector<std::string> notes;  ///< what is doubtful about its shape
  std::vector<std::string> losses;  ///< what it has not kept of its shape
  WarpFigures warp;
  std::vector<std::string> warnings;  ///< what it has lost
  std::optional<OptimiseFigures> optimised = std::nullopt;  ///< where vertices moved
  FeatureDecision features = {};                            ///< whether they moved onto sharp edges
  std::optional<FeatureFigures> kept = std::nullopt;        ///< how much of these the mesh has
  std::optional<PythonMiddles> middles = std::nullopt;  ///< where tetrahedra have ten nodes
  std::optional<DroppedPieces> dropped = std::nullopt;  ///< where some were to stay
};

}  // namespace certet::python
