// Mesh files: what `certet check` does with one, and the survey that `certet
// convert` begins with.

#include "certet/check.hpp"
#include "certet/examine.hpp"
#include "reader.hpp"
#include "targets.hpp"

namespace fuzz {

void mesh_file(Bytes bytes) {
  read_mesh_or_refuse(bytes, [](const certet::FileMesh& mesh, certet::Context& context) {
    if (!mesh.labels.empty() && mesh.labels.size() != mesh.tets.size())
      throw Finding("there are labels, but not one for each tetrahedron");
    const std::span<const certet::Tet<std::uint64_t>> tets(mesh.tets);
    certet::check(mesh, context);
    certet::examine(mesh.points, tets, mesh.labels, context);
    certet::compare_surfaces(mesh, certet::survey(mesh, context));
    certet::checksum(mesh);
  });
}

}  // namespace fuzz
