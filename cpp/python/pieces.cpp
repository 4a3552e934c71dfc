#include "pieces.hpp"

#include <pybind11/stl.h>

#include <span>

#include "certet/count_pieces.hpp"
#include "certet/formats.hpp"
#include "python_mesh.hpp"
#include "run.hpp"

namespace certet::python {
namespace {

namespace py = pybind11;

py::dict told_of(const Pieces& found) {
  py::dict regions;
  for (const auto& [label, pieces] : found.regions)
    regions[py::int_(label)] = py::make_tuple(pieces.by_faces, pieces.by_vertices);
  py::dict result;
  result["by_faces"] = found.whole.by_faces;
  result["by_vertices"] = found.whole.by_vertices;
  result["largest_tets"] = found.largest;
  result["regions"] = regions;
  result["nonmanifold_edges"] = found.surface.edges;
  result["nonmanifold_vertices"] = found.surface.vertices;
  result["edge_places"] = found.surface.edge_places;
  result["vertex_places"] = found.surface.vertex_places;
  return result;
}

}  // namespace

void declare_pieces(py::module_& module) {
  module.def("pieces", [](const PythonMesh& mesh) {
    Context context;
    Pieces found;
    run(context, [&] { found = count_pieces(mesh.mesh, context); });
    return told_of(found);
  });
  module.def("pieces", [](const FileMesh& mesh) {
    Context context;
    Pieces found;
    run(context, [&] {
      found = count_pieces(mesh.points, std::span<const Tet<std::uint64_t>>(mesh.tets),
                           mesh.labels, context);
    });
    return told_of(found);
  });
}

}  // namespace certet::python
