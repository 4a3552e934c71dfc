// A torus, given by a formula, measured in memory and not written at all.

#include <cstdio>
#include <variant>

#include "certet/error.hpp"
#include "certet/formula.hpp"
#include "certet/quality.hpp"
#include "certet/stuffing.hpp"

int main() try {
  if (!certet::can_read_formulas()) {
    std::puts("this certet was built without formulas");
    return 0;
  }
  const certet::FormulaDomain torus("(sqrt(x^2+y^2)-1)^2+z^2-0.16",
                                       {{-1.5, -1.5, -0.5}, {1.5, 1.5, 0.5}}, 0.1, 2);
  certet::Context context;
  const certet::Mesh mesh = certet::stuff(torus, torus.lattice(), torus.frame(), {}, context);
  const certet::Quality quality = std::visit(
      [&]<class Index>(const certet::Buffer<certet::Tet<Index>>& tets) {
        return certet::measure_lattice(mesh.points, 0,
                                       std::span<const certet::Tet<Index>>(tets));
      },
      mesh.tets);
  std::printf("%zu points, %zu tetrahedra, dihedral angles from %.2f to %.2f degrees\n",
              mesh.points.size(), mesh.tet_count(), quality.min_dihedral,
              quality.max_dihedral);
} catch (const certet::Error& error) {
  std::fprintf(stderr, "formula: %s\n", error.what());
  return 1;
}
