// A closed surface of triangles, an octahedron, filled with tetrahedra.

#include <cstdio>

#include "certet/error.hpp"
#include "certet/quality.hpp"
#include "certet/stuffing.hpp"
#include "certet/surface.hpp"

int main() try {
  certet::TriangleSurface octahedron;
  octahedron.name = "an octahedron";
  octahedron.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  octahedron.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                          {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};

  // What a user would want to know of a surface that comes from elsewhere.
  if (!certet::inspect(octahedron).closed()) return 1;
  const auto domain = certet::surface_domain(octahedron, {0.1, 2});  // a long edge of 0.1
  certet::Context context;
  const certet::Mesh mesh =
      certet::stuff(*domain, domain->lattice(), domain->frame(), {}, context);
  const certet::Quality quality = std::visit(
      [&](const auto& tets) {
        return certet::measure_lattice(mesh.points, 0, std::span(tets.data(), tets.size()));
      },
      mesh.tets);
  std::printf("%zu tetrahedra, dihedral angles from %.2f to %.2f degrees\n", mesh.tet_count(),
              quality.min_dihedral, quality.max_dihedral);
} catch (const certet::Error& error) {
  std::fprintf(stderr, "surface: %s\n", error.what());
  return 1;
}
