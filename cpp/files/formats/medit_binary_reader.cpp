#include <algorithm>
#include <utility>

#include "cursor.hpp"
#include "medit_binary.hpp"
#include "middle_nodes_read.hpp"
#include "numbered_patches.hpp"
#include "registry.hpp"

namespace certet::formats {
namespace {

using namespace medit_binary;

class MeditBinaryReader {
 public:
  MeditBinaryReader(const std::filesystem::path& path, const Context& context)
      : file_(path, &context), cursor_(file_) {}

  FileMesh read();

 private:
  void read_heading();
  void read_block(std::int32_t keyword);
  void read_points();
  void read_tets(std::size_t nodes);
  void read_triangles(std::size_t nodes);
  std::uint64_t vertex();
  std::uint64_t place() { return whole(version_ >= 3); }
  std::uint64_t index() { return whole(version_ >= 4); }
  /// A negative number becomes one that is too large for anything.
  std::uint64_t whole(bool wide) {
    return static_cast<std::uint64_t>(wide ? cursor_.binary<std::int64_t>()
                                           : cursor_.binary<std::int32_t>());
  }
  [[nodiscard]] std::uint64_t index_bytes() const { return version_ >= 4 ? 8 : 4; }
  double coordinate() { return version_ == 1 ? cursor_.binary<float>() : cursor_.binary<double>(); }
  std::int32_t reference();

  InputFile file_;
  Cursor cursor_;
  std::int32_t version_ = 0;
  bool has_points_ = false, has_tets_ = false;
  FileMesh mesh_;
  NumberedPatches patches_;
};

void MeditBinaryReader::read_heading() {
  if (file_.size() < 8) file_.fail("it is not a binary MEDIT file");
  const auto first = cursor_.binary<std::int32_t>();
  if (first == 0x01000000) file_.fail("its byte order is not this machine's");
  if (first != mark) file_.fail("it is not a binary MEDIT file");
  version_ = cursor_.binary<std::int32_t>();
  if (version_ < 1 || version_ > 4)
    file_.fail("version " + std::to_string(version_) + " of MEDIT is not known");
}

FileMesh MeditBinaryReader::read() {
  read_heading();
  for (;;) {
    const std::uint64_t begin = cursor_.position();
    const auto keyword = cursor_.binary<std::int32_t>();
    if (keyword == end) break;
    const std::uint64_t next = place();
    if (next <= begin || next > file_.size())
      file_.fail("it is damaged: the block behind one at byte " + std::to_string(begin) +
                 " is not in the file");
    read_block(keyword);
    if (cursor_.position() > next) file_.fail("it is damaged: its blocks overlap");
    cursor_.go_to(next);
  }
  if (!has_points_ || !has_tets_) file_.fail("it has no vertices or no tetrahedra");
  patches_.give(mesh_);
  part_middle_nodes(mesh_, usual_order, file_);
  return std::move(mesh_);
}

/// What is not asked for is passed over.
void MeditBinaryReader::read_block(std::int32_t keyword) {
  constexpr std::int32_t prisms = 9, hexahedra = 10;
  if (keyword == prisms || keyword == hexahedra) file_.fail("it has cells other than tetrahedra");
  if (keyword == dimension && cursor_.binary<std::int32_t>() != 3)
    file_.fail("its dimension is not 3");
  if (keyword == vertices && !std::exchange(has_points_, true)) read_points();
  if (keyword == tetrahedra_p2_ordering)
    file_.fail("its tetrahedra of ten nodes have an order of their own, which is not known");
  if (keyword == triangles) read_triangles(3);
  if (keyword == triangles_p2) read_triangles(6);
  if (keyword == tetrahedra && !std::exchange(has_tets_, true)) read_tets(4);
  if (keyword == tetrahedra_p2 && !std::exchange(has_tets_, true)) read_tets(10);
}

void MeditBinaryReader::read_points() {
  const std::uint64_t bytes = (version_ == 1 ? 12 : 24) + index_bytes();
  mesh_.points.resize(cursor_.checked(place(), bytes, "vertices"));
  for (Point3& point : mesh_.points) {
    for (double& number : point) number = coordinate();
    index();
  }
}

std::uint64_t MeditBinaryReader::vertex() {
  const std::uint64_t number = index();
  if (number == 0) file_.fail("it names vertex 0, but vertices are counted from 1");
  return number - 1;
}

void MeditBinaryReader::read_triangles(std::size_t nodes) {
  const std::uint64_t triangles =
      cursor_.checked(place(), (nodes + 1) * index_bytes(), "triangles");
  for (std::uint64_t i = 0; i < triangles; ++i) {
    std::array<std::uint64_t, 3> face;
    for (std::uint64_t& point : face) point = vertex();
    for (std::size_t middle = 3; middle < nodes; ++middle) vertex();
    patches_.add(face, static_cast<std::int64_t>(index()));
  }
}

void MeditBinaryReader::read_tets(std::size_t nodes) {
  const std::uint64_t tets = cursor_.checked(place(), (nodes + 1) * index_bytes(), "tetrahedra");
  mesh_.tets.reserve(tets);
  if (nodes > 4) mesh_.middles.reserve(tets);
  mesh_.labels.resize(tets);
  for (std::uint64_t i = 0; i < tets; ++i) {
    for (std::size_t place = 0; place < nodes; ++place) take_node(mesh_, place, vertex());
    mesh_.labels[i] = reference();
  }
}

std::int32_t MeditBinaryReader::reference() {
  const auto value = static_cast<std::int64_t>(index());
  if (!std::in_range<std::int32_t>(value)) file_.fail("it has a reference beyond 32 bits");
  return static_cast<std::int32_t>(value);
}

}  // namespace

FileMesh read_medit_binary(const std::filesystem::path& file, const Context& context) {
  return MeditBinaryReader(file, context).read();
}

}  // namespace certet::formats
