#pragma once
/// \file
/// What a `certet.Mesh` of Python holds.

#include <string>
#include <vector>

#include "certet/buffer.hpp"
#include "certet/mesh.hpp"
#include "certet/warp_figures.hpp"

namespace certet::python {

/// A finished mesh; arrays handed out share its memory.
struct PythonMesh {
  Mesh mesh;
  Buffer<Point3> world;  ///< its points
  std::vector<std::string> notes;  ///< what is doubtful about its shape
  std::vector<std::string> losses;  ///< what it has not kept of its shape
  WarpFigures warp;
};

}  // namespace certet::python
