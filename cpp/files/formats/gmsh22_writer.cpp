// Gmsh 2.2, ASCII: the version that most other programs read.

#include "element_nodes.hpp"
#include "gmsh_elements.hpp"
#include "gmsh_groups.hpp"
#include "line.hpp"
#include "registry.hpp"
#include "section.hpp"
#include "sheet_text.hpp"
#include "streamed_writer.hpp"

namespace certet::formats {
namespace {

class Gmsh22Writer final : public StreamedWriter {
 public:
  Gmsh22Writer(const std::filesystem::path& file, const MeshSize& size)
      : StreamedWriter(file, size), groups_(survey()), latest_(groups_), nodes_(size, gmsh_order),
        text_(file_, 0) {
    text_.append_text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
    text_.append_text(groups_.naming_sections());
    text_.append(Line() << "$Nodes\n" << size.points << '\n');
  }

 private:
  void put_points(std::uint64_t first, std::span<const Point3> points) override {
    for (const Point3& p : points)
      text_.append(Line() << ++first << ' ' << p[0] << ' ' << p[1] << ' ' << p[2] << '\n');
  }

  void open_tets() override {
    text_.append(Line() << "$EndNodes\n$Elements\n" << size_.tets + face_count(survey()) << '\n');
  }

  void put_tets(std::uint64_t first, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override {
    for (std::size_t i = 0; i < tets.size(); ++i)
      put_element(first + i, nodes_.has_middles() ? gmsh_tetrahedron_10 : gmsh_tetrahedron,
                  latest_.number_of(labels[i], file_), nodes_.tet(tets[i]));
  }

  /// Its number, its type, two tags (the physical and the elementary group), its
  /// points.
  void put_element(std::uint64_t number, int type, std::int32_t tag,
                   std::span<const std::uint64_t> points) {
    Line line;
    line << number + 1 << ' ' << type << " 2 " << tag << ' ' << tag;
    for (const std::uint64_t point : points) line << ' ' << point + 1;
    text_.append(line << '\n');
  }

  void close() override {
    std::uint64_t number = size_.tets;
    Sheets::for_each_face(survey(), [&](const BoundaryFace& face, std::int32_t sheet) {
      put_element(number++, nodes_.has_middles() ? gmsh_triangle_6 : gmsh_triangle, sheet,
                  nodes_.face(face.points));
    });
    text_.append_text("$EndElements\n");
    text_.flush();
  }

  GmshGroups groups_;
  LatestGroup latest_;
  ElementNodes nodes_;
  Section text_;
};

}  // namespace

std::unique_ptr<MeshWriter> open_gmsh22(const std::filesystem::path& file,
                                        const MeshSize& size) {
  return std::make_unique<Gmsh22Writer>(file, size);
}

std::uint64_t gmsh22_bytes(const MeshSize& size) {
  const std::uint64_t digits = digits_of(size.points);
  const Survey& survey = survey_of(size);
  const SheetText text(survey, NameRule::quoted);
  const std::uint64_t number = digits_of(size.tets + text.faces);
  const ElementNodes nodes(size);
  // The number, " 4 2", both tags, the points and the end of the line.
  return 200 + GmshGroups(survey).naming_sections().size() + size.points * (digits + 60 + 4) +
         size.tets * (number + 4 + 2 + nodes.per_tet() * (digits + 1) + 1) + 2 * text.label_digits +
         text.faces * (number + 4 + 2 + nodes.per_face() * (digits + 1) + 1) + 2 * text.number_digits;
}

}  // namespace certet::formats
