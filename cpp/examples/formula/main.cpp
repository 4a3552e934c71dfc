// A torus, given by a formula: how good is its mesh?
#include <cstdio>

#include "certet/certet.hpp"

int main() {
  if (!certet::can_read_formulas()) return 0;  // built without muParser
  const certet::FormulaDomain torus("(sqrt(x^2+y^2)-1)^2+z^2-0.16",
                                    {{-1.5, -1.5, -0.5}, {1.5, 1.5, 0.5}}, 0.1, 2);
  const certet::Mesh mesh = certet::mesh(torus);
  const certet::Quality found = certet::quality(mesh).world;
  std::printf("%zu tetrahedra, dihedral angles from %.2f to %.2f degrees\n", mesh.tet_count(),
              found.min_dihedral, found.max_dihedral);
}
