#include "patches.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "certet/patches.hpp"
#include "faces.hpp"
#include "python_mesh.hpp"

namespace certet::python {
namespace {

namespace py = pybind11;

/// For each a tuple of its name, triangles and area, in the order of patches.
py::list told_of_patches(Survey made, std::span<const Point3> points) {
  const SharedFaces shared(std::move(made.boundary));
  std::vector<BoundaryFace>& kept = *shared.kept;
  std::ranges::stable_sort(kept, {}, &BoundaryFace::patch);
  py::list all;
  for (auto begin = kept.cbegin(); begin != kept.cend();) {
    const auto end = std::find_if(begin, kept.cend(), [&](const BoundaryFace& face) {
      return face.patch != begin->patch;
    });
    const std::span<const BoundaryFace> faces(begin, end);
    all.append(py::make_tuple(name_of(begin->patch, made), points_of(faces, shared.owner),
                              area_of(faces, points)));
    begin = end;
  }
  return all;
}

/// Nothing is changed where one of them is refused.
void name_patches_of(PythonMesh& mesh,
                     const std::vector<std::pair<std::string, std::string>>& choices) {
  std::vector<PatchChoice> before = mesh.mesh.patches;
  try {
    for (const auto& [name, where] : choices) mesh.mesh.patches.push_back(patch_choice(name, where));
    static_cast<void>(found_in(mesh.mesh));
  } catch (...) {
    mesh.mesh.patches = std::move(before);
    throw;
  }
}

}  // namespace

void declare_patches(py::module_& module) {
  declare_told(module, "patches", told_of_patches);
  module.def("name_patches", name_patches_of);
}

}  // namespace certet::python
