// A segmented image made in memory, of two labels; every tetrahedron gets its own.

#include <cstdio>

#include "certet/error.hpp"
#include "certet/formats.hpp"
#include "certet/image.hpp"
#include "certet/write_mesh.hpp"

int main() try {
  certet::Image image;
  image.name = "two boxes";
  image.size = {20, 16, 12};
  image.spacing = {1, 1, 2};
  certet::Buffer<std::uint8_t> voxels(20 * 16 * 12);
  for (std::size_t v = 0; v < voxels.size(); ++v) voxels[v] = v % 20 < 10 ? 1 : 2;
  image.voxels = std::move(voxels);

  const auto domain = certet::label_domain(std::move(image), {}, {});  // all labels but 0
  certet::Context context;
  const certet::Stuffing stuffing(*domain, domain->lattice(), certet::Method::midpoint, context);
  const auto file = certet::open_writer("labels.vtu", certet::Format::vtu,
                                        {stuffing.point_count(), stuffing.tet_count(), true});
  const certet::WrittenMesh mesh =
      certet::write_mesh(stuffing, domain->frame(), certet::cut_slabs(stuffing, 64 << 20),
                         *file, context);
  file->finish();
  std::printf("labels.vtu: %llu tetrahedra, dihedral angles from %.2f to %.2f degrees\n",
              static_cast<unsigned long long>(mesh.lattice.tets), mesh.lattice.min_dihedral,
              mesh.lattice.max_dihedral);
} catch (const certet::Error& error) {
  std::fprintf(stderr, "label_image: %s\n", error.what());
  return 1;
}
