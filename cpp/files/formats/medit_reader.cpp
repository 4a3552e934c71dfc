#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "cursor.hpp"
#include "middle_nodes_read.hpp"
#include "numbered_patches.hpp"
#include "registry.hpp"

namespace certet::formats {
namespace {

/// How many words a line of a section has that is passed over.
constexpr std::pair<std::string_view, int> other_sections[] = {
    {"Edges", 3},   {"Corners", 1},  {"RequiredVertices", 1},  {"RequiredEdges", 1},
    {"Ridges", 1},  {"Normals", 3},  {"RequiredTriangles", 1}, {"NormalAtVertices", 2},
    {"Tangents", 3}, {"TangentAtVertices", 2}, {"Quadrilaterals", 5},
};

class MeditReader {
 public:
  MeditReader(const std::filesystem::path& path, const Context& context)
      : file_(path, &context), words_(file_) {}

  FileMesh read() {
    read_heading();
    bool has_points = false, has_tets = false;
    for (;;) {
      const std::string_view word = words_.word();
      if (word == "End") break;
      if (word == "Vertices" && !has_points) {
        read_points();
        has_points = true;
      } else if ((word == "Tetrahedra" || word == "TetrahedraP2") && !has_tets) {
        read_tets(word == "Tetrahedra" ? 4 : 10);
        has_tets = true;
      } else if (word == "Triangles" || word == "TrianglesP2") {
        read_triangles(word == "Triangles" ? 3 : 6);
      } else if (!pass_over(word)) {
        refuse(word);
      }
    }
    if (!has_points || !has_tets) file_.fail("it has no vertices or no tetrahedra");
    if (!words_.word().empty()) file_.fail("it goes on behind its end");
    patches_.give(mesh_);
    part_middle_nodes(mesh_, usual_order, file_);
    return std::move(mesh_);
  }

 private:
  void read_heading();
  void read_points();
  void read_tets(std::size_t nodes);
  void read_triangles(std::size_t nodes);
  std::uint64_t vertex();
  std::uint64_t count(std::uint64_t shortest_line);
  bool pass_over(std::string_view section);
  [[noreturn]] void refuse(std::string_view word) const;

  InputFile file_;
  Cursor words_;
  FileMesh mesh_;
  NumberedPatches patches_;
};

void MeditReader::read_heading() {
  if (words_.word() != "MeshVersionFormatted") file_.fail("it is not an ASCII MEDIT file");
  const auto version = words_.number<int>("a version");
  if (version < 1 || version > 4)
    file_.fail("version " + std::to_string(version) + " of MEDIT is not known");
  if (words_.word() != "Dimension" || words_.number<int>("a dimension") != 3)
    file_.fail("its dimension is not 3");
}

std::uint64_t MeditReader::count(std::uint64_t shortest_line) {
  return words_.checked(words_.number<std::uint64_t>("a count"), shortest_line, "lines");
}

bool MeditReader::pass_over(std::string_view section) {
  const auto other = std::ranges::find(other_sections, section,
                                       &std::pair<std::string_view, int>::first);
  if (other == std::end(other_sections)) return false;
  const std::uint64_t lines = count(2);
  for (std::uint64_t i = 0; i < lines * static_cast<std::uint64_t>(other->second); ++i)
    words_.number<double>("a number");
  return true;
}

void MeditReader::read_points() {
  mesh_.points.resize(count(std::string_view("0 0 0 0\n").size()));
  for (Point3& point : mesh_.points) {
    for (double& coordinate : point) coordinate = words_.number<double>("a coordinate");
    words_.number<std::int32_t>("a reference");
  }
}

std::uint64_t MeditReader::vertex() {
  const auto number = words_.number<std::uint64_t>("the number of a vertex");
  if (number == 0) file_.fail("it names vertex 0, but vertices are counted from 1");
  return number - 1;
}

void MeditReader::read_triangles(std::size_t nodes) {
  const std::uint64_t triangles = count(2 * (nodes + 1));
  for (std::uint64_t i = 0; i < triangles; ++i) {
    std::array<std::uint64_t, 3> face;
    for (std::uint64_t& point : face) point = vertex();
    for (std::size_t middle = 3; middle < nodes; ++middle) vertex();
    patches_.add(face, words_.number<std::int64_t>("a reference"));
  }
}

void MeditReader::read_tets(std::size_t nodes) {
  const std::uint64_t tets = count(2 * (nodes + 1));
  mesh_.tets.reserve(tets);
  if (nodes > 4) mesh_.middles.reserve(tets);
  mesh_.labels.resize(tets);
  for (std::uint64_t i = 0; i < tets; ++i) {
    for (std::size_t place = 0; place < nodes; ++place) take_node(mesh_, place, vertex());
    mesh_.labels[i] = words_.number<std::int32_t>("a reference");
  }
}

void MeditReader::refuse(std::string_view word) const {
  if (word.empty()) file_.fail("it is cut off: its 'End' is missing");
  if (word == "TetrahedraP2") file_.fail("it has tetrahedra of four nodes and of ten, or twice");
  if (word == "Vertices" || word == "Tetrahedra")
    file_.fail("it has two sections " + in_quotes(word));
  file_.fail("its section " + in_quotes(word) + " is not known");
}

}  // namespace

FileMesh read_medit(const std::filesystem::path& file, const Context& context) {
  return MeditReader(file, context).read();
}

}  // namespace certet::formats
