// A closed surface of triangles, an octahedron, is filled with tetrahedra.
#include "certet/certet.hpp"

int main() {
  certet::TriangleSurface octahedron;
  octahedron.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  octahedron.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                          {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  const auto solid = certet::surface_domain(octahedron, {0.1});  // a long edge of the lattice
  certet::write(certet::mesh(*solid), "octahedron.inp");
}
