#include <limits>

#include "element_nodes.hpp"
#include "line.hpp"
#include "registry.hpp"
#include "section.hpp"
#include "sheet_text.hpp"
#include "sheets.hpp"
#include "streamed_writer.hpp"

namespace certet::formats {
namespace {

class MeditWriter final : public StreamedWriter {
 public:
  MeditWriter(const std::filesystem::path& file, const MeshSize& size)
      : StreamedWriter(file, size), nodes_(size), text_(file_, 0) {
    // Version 2 has doubles, version 4 has indices of 64 bits beside.
    const std::uint64_t greatest = std::max(size.points, size.tets);
    const bool wide = greatest > std::uint64_t{std::numeric_limits<std::int32_t>::max()};
    text_.append_text(wide ? "MeshVersionFormatted 4\n" : "MeshVersionFormatted 2\n");
    text_.append_text("Dimension 3\n");
    open("Vertices", size.points);
  }

 private:
  void open(std::string_view section, std::uint64_t lines) {
    text_.append(Line() << section << '\n' << lines << '\n');
  }
  void put_points(std::uint64_t, std::span<const Point3> points) override {
    for (const Point3& p : points)
      text_.append(Line() << p[0] << ' ' << p[1] << ' ' << p[2] << " 0\n");
  }

  void open_tets() override {
    open(nodes_.has_middles() ? "TetrahedraP2" : "Tetrahedra", size_.tets);
  }

  void put_element(std::span<const std::uint64_t> points, std::int32_t reference) {
    Line line;
    for (const std::uint64_t point : points) line << point + 1 << ' ';
    text_.append(line << reference << '\n');
  }

  void put_tets(std::uint64_t, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override {
    for (std::size_t i = 0; i < tets.size(); ++i) put_element(nodes_.tet(tets[i]), labels[i]);
  }

  void close() override {
    open(nodes_.has_middles() ? "TrianglesP2" : "Triangles", face_count(survey()));
    Sheets::for_each_face(survey(), [&](const BoundaryFace& face, std::int32_t number) {
      put_element(nodes_.face(face.points), number);
    });
    text_.append_text("End\n");
    text_.flush();
  }

  ElementNodes nodes_;
  Section text_;
};

}  // namespace

std::unique_ptr<MeshWriter> open_medit(const std::filesystem::path& file, const MeshSize& size) {
  return std::make_unique<MeditWriter>(file, size);
}

std::uint64_t medit_bytes(const MeshSize& size) {
  // Most doubles need 17 digits, a sign or exponent now and then, and a point.
  constexpr std::uint64_t point_line = 3 * 20 + 2;
  const std::uint64_t digits = digits_of(size.points);
  const ElementNodes nodes(size);
  const std::uint64_t tet_line = nodes.per_tet() * (digits + 1) + 1;
  const std::uint64_t face_line = nodes.per_face() * (digits + 1) + 1;
  const SheetText text(survey_of(size), NameRule::quoted);
  return 100 + size.points * point_line + size.tets * tet_line + text.label_digits +
         text.faces * face_line + text.number_digits;
}

}  // namespace certet::formats
