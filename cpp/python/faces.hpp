#pragma once
/// \file
/// Triangles of a mesh, as arrays.

#include <pybind11/numpy.h>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "certet/examine.hpp"
#include "certet/formats.hpp"
#include "certet/survey.hpp"
#include "python_mesh.hpp"
#include "run.hpp"

namespace certet::python {

/// Faces whose memory Python's arrays share: they are there for as long as an owner of them.
template <class Faces>
struct SharedFaces {
  std::vector<Faces>* kept;
  pybind11::capsule owner;

  explicit SharedFaces(std::vector<Faces> found)
      : kept(new std::vector<Faces>(std::move(found))),
        owner(kept, [](void* memory) { delete static_cast<std::vector<Faces>*>(memory); }) {}
};

/// The points of faces as an array of shape (n, 3) that shares their memory.
inline pybind11::array points_of(std::span<const BoundaryFace> faces,
                                 const pybind11::handle& owner) {
  using pybind11::ssize_t;
  constexpr auto item = static_cast<ssize_t>(sizeof(std::uint64_t));
  const std::uint64_t* const first = faces.empty() ? nullptr : faces.front().points.data();
  return {pybind11::dtype::of<std::uint64_t>(), {static_cast<ssize_t>(faces.size()), ssize_t{3}},
          {static_cast<ssize_t>(sizeof(BoundaryFace)), item}, first, owner};
}

inline double area_of(std::span<const BoundaryFace> faces, std::span<const Point3> points) {
  double area = 0;
  for (const BoundaryFace& face : faces) {
    const auto [a, b, c] = face.points;
    area += certet::area_of(points[a], points[b], points[c]);
  }
  return area;
}

/// The survey of a mesh, or of what a file holds, which stops at Ctrl-C.
template <class AnyMesh>
Survey found_in(const AnyMesh& mesh) {
  Context context;
  Survey found;
  run(context, [&] { found = survey(mesh, context); });
  return found;
}

/// A function of Python's, of a mesh that was made here or of what a file holds: what `told` makes
/// of its survey and its points in world coordinates.
inline void declare_told(pybind11::module_& module, const char* name,
                         pybind11::list (*told)(Survey, std::span<const Point3>)) {
  module.def(name, [told](const PythonMesh& mesh) {
    return told(found_in(mesh.mesh), mesh.world);
  });
  module.def(name, [told](const FileMesh& mesh) { return told(found_in(mesh), mesh.points); });
}

}  // namespace certet::python
