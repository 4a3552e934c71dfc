#pragma once
/// \file
/// From what Python gives to a mesh.

#include <pybind11/numpy.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certet/features.hpp"
#include "certet/kept.hpp"
#include "certet/method.hpp"
#include "certet/pieces.hpp"
#include "certet/size_field.hpp"
#include "certet/surface.hpp"
#include "python_mesh.hpp"
#include "run.hpp"

namespace certet::python {

namespace py = pybind11;

struct Options {
  Method method = default_method;
  int threads = 0;
  int order = 1;        ///< 2: tetrahedra of ten nodes
  bool curved = false;  ///< whether middle nodes of the surfaces are put on these
  double optimise = 0;  ///< degrees that vertices move for; 0: they stay
  FeatureChoice features = {};
  std::int32_t grade = 0;  ///< levels by which the mesh is graded, at most
  std::optional<SizeField> sizes = {};  ///< how large tetrahedra may be
  std::optional<KeepRule> keep = {};    ///< which pieces stay
  std::uint64_t target_tets = 0;        ///< about so many are wanted; 0: as the size says
  Follow follow = {};                   ///< is told how far the run is
};

/// A shape that can be put on lattices of several sizes, and what is doubtful about it.
struct Shape {
  SizedShape sized;
  std::vector<std::string> notes = {};
  /// What is wrong with a mesh of it.
  std::function<std::vector<std::string>(const Mesh&)> warnings = {};
};

/// Of asking a Python function, as `SizedShape` has it: Python takes its time.
inline constexpr double cost_of_python = 16;

/// Of what has no pieces that can be counted but on a lattice.
std::optional<PieceBounds> unknown_pieces(Context& context);

/// `make` makes the shape; it runs, like all the rest, without Python's lock.
std::shared_ptr<PythonMesh> mesh_of(const std::function<Shape(const Context&)>& make, double size,
                                    const Options& options);

using PointArray = py::array_t<double, py::array::c_style | py::array::forcecast>;
using TriangleArray = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

/// Both of shape (n, 3).  \throws Error `bad_input`.
TriangleSurface surface_of(const PointArray& points, const TriangleArray& triangles,
                           std::string name);

/// A surface that bounds a solid.
struct MendedSurface {
  TriangleSurface surface;
  bool open = false;  ///< its holes are to be closed by the winding number
  std::vector<std::string> notes;
};
/// \throws Error `bad_input` for an open one, unless its holes are to be closed.
MendedSurface mend(TriangleSurface surface, bool close_holes);

}  // namespace certet::python
