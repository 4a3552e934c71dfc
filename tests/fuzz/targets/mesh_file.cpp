// Mesh files: what `certet check` does with one, and the survey that `certet
// convert` begins with.

#include "certet/check.hpp"
#include "certet/examine.hpp"
#include "certet/formats.hpp"
#include "reader.hpp"
#include "targets.hpp"

namespace fuzz {

void mesh_file(Bytes bytes) {
  if (bytes.empty()) return;
  const InputFile file = mesh_file_of(bytes);
  certet::Context context;
  context.threads = 1;
  read_or_refuse([&] {
    const certet::FileMesh mesh = certet::read(file.path(), context);
    if (!mesh.labels.empty() && mesh.labels.size() != mesh.tets.size())
      throw Finding("there are labels, but not one for each tetrahedron");
    const std::span<const certet::Tet<std::uint64_t>> tets(mesh.tets);
    certet::check(mesh.points, tets, context);
    certet::examine(mesh.points, tets, mesh.labels, context);
    certet::compare_surfaces(mesh, certet::survey(mesh, context));
    certet::checksum(mesh);
  });
}

}  // namespace fuzz
