#include "certet/count_pieces.hpp"

#include <vector>

#include "mesh_faces.hpp"
#include "surface_faults.hpp"

namespace certet {
namespace {

template <class Index>
Pieces pieces_of(std::span<const Point3> points, std::span<const Tet<Index>> tets,
                 std::span<const std::int32_t> labels, Context& context) {
  core::MeshFaces faces = core::find_mesh_faces(points.size(), tets, labels, context);
  faces.pieces.surface = core::find_surface_faults(faces.outer, points, context);
  return std::move(faces.pieces);
}

}  // namespace

Pieces count_pieces(std::span<const Point3> points, std::span<const Tet<std::uint32_t>> tets,
                    std::span<const std::int32_t> labels, Context& context) {
  return pieces_of(points, tets, labels, context);
}

Pieces count_pieces(std::span<const Point3> points, std::span<const Tet<std::uint64_t>> tets,
                    std::span<const std::int32_t> labels, Context& context) {
  return pieces_of(points, tets, labels, context);
}

Pieces count_pieces(const Mesh& mesh, Context& context) {
  const Buffer<Point3> world = world_points(mesh);
  return std::visit(
      [&]<class Index>(const Buffer<Tet<Index>>& tets) {
        return pieces_of<Index>(world, tets, mesh.labels, context);
      },
      mesh.tets);
}

}  // namespace certet
