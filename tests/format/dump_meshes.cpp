/// Writes meshes for an independent reader.
///
/// usage: certet_dump_meshes FOLDER
/// For each of them: NAME.vtu, NAME.mesh, and NAME.txt, which holds the numbers
/// of points, tetrahedra and labels in its first line, then one line for each:
/// coordinates in hexadecimal, indices from 0, labels.

#include <cstdio>
#include <stdexcept>

#include "sample_mesh.hpp"

namespace {

using certet::test::SampleMesh;

void dump(const std::filesystem::path& file, const SampleMesh& mesh) {
  std::FILE* out = std::fopen(file.c_str(), "w");
  if (out == nullptr) throw std::runtime_error("cannot open " + file.string());
  std::fprintf(out, "%zu %zu %zu\n", mesh.points.size(), mesh.tets.size(), mesh.labels.size());
  for (const auto& [x, y, z] : mesh.points) std::fprintf(out, "%a %a %a\n", x, y, z);
  for (const auto& [a, b, c, d] : mesh.tets) std::fprintf(out, "%u %u %u %u\n", a, b, c, d);
  for (const std::int32_t label : mesh.labels) std::fprintf(out, "%d\n", label);
  if (std::fclose(out) != 0) throw std::runtime_error("cannot write " + file.string());
}

void write_all(const std::filesystem::path& folder, const std::string& name,
               const SampleMesh& mesh) {
  certet::test::write(folder / (name + ".vtu"), mesh, 1000);
  certet::test::write(folder / (name + ".mesh"), mesh, 1000);
  dump(folder / (name + ".txt"), mesh);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("usage: certet_dump_meshes FOLDER");
  using certet::test::sample_mesh;
  // Not smaller: meshio takes one array for another where, as in a file of one
  // tetrahedron, 4/3 of an offset is the offset of a later array.
  write_all(argv[1], "small", sample_mesh(8, 5, false));
  write_all(argv[1], "plain", sample_mesh(3000, 10'000, false));
  write_all(argv[1], "labelled", sample_mesh(5000, 20'001, true));
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
