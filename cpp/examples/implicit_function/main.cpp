// A ball, given by a function that is negative inside, becomes ball.vtu.

#include <cstdio>

#include "certet/error.hpp"
#include "certet/formats.hpp"
#include "certet/function_domain.hpp"
#include "certet/stuffing.hpp"
#include "certet/write_mesh.hpp"

int main() try {
  const certet::Frame frame{.size = 0.1};  // a long edge of 0.1 world units
  const certet::FunctionDomain ball(
      [](certet::Point3 p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 1; }, frame);
  const certet::Lattice lattice{{-24, -24, -24}, {24, 24, 24}};

  certet::Context context;
  const certet::Stuffing stuffing(ball, lattice, {}, context);
  const auto file = certet::open_writer("ball.vtu", certet::Format::vtu,
                                        {stuffing.point_count(), stuffing.tet_count(), false});
  const certet::WrittenMesh mesh = certet::write_mesh(
      stuffing, frame, certet::cut_slabs(stuffing, 64 << 20), *file, context);
  file->finish();
  std::printf("ball.vtu: %llu tetrahedra, dihedral angles from %.2f to %.2f degrees\n",
              static_cast<unsigned long long>(mesh.lattice.tets), mesh.lattice.min_dihedral,
              mesh.lattice.max_dihedral);
} catch (const certet::Error& error) {
  std::fprintf(stderr, "implicit_function: %s\n", error.what());
  return 1;
}
