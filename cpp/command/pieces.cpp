#include "pieces.hpp"

#include <fmt/format.h>

#include "table.hpp"

namespace certet::command {

std::string sentence(const Pieces& pieces, std::uint64_t tets) {
  const auto& [by_faces, by_vertices] = pieces.whole;
  if (by_faces <= 1) return fmt::format("{}", by_faces);
  return fmt::format("{} by faces, {} by vertices; the largest has {:.3g} % of the tetrahedra",
                     grouped(by_faces), grouped(by_vertices),
                     100 * static_cast<double>(pieces.largest) / static_cast<double>(tets));
}

std::string sentence(const SurfaceFaults& faults) {
  const Point3& at = faults.edge_places.empty() ? faults.vertex_places.front()
                                                : faults.edge_places.front();
  return fmt::format("no manifold at {} edges and {} vertices, the first at ({:.6g}, {:.6g}, {:.6g})",
                     grouped(faults.edges), grouped(faults.vertices), at[0], at[1], at[2]);
}

void add_pieces(Json& json, const Pieces& pieces) {
  json["pieces"] = {{"by_faces", pieces.whole.by_faces},
                    {"by_vertices", pieces.whole.by_vertices},
                    {"largest_tets", pieces.largest}};
  json["nonmanifold"] = {{"edges", pieces.surface.edges},
                         {"vertices", pieces.surface.vertices},
                         {"edge_places", pieces.surface.edge_places},
                         {"vertex_places", pieces.surface.vertex_places}};
}

}  // namespace certet::command
