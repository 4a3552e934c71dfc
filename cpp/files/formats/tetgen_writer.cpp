// TetGen: points in .node, tetrahedra with their regions in .ele, the boundary
// with its patches in .face, whose triangles are those of corners.  Numbers count from 1.

#include "element_nodes.hpp"
#include "line.hpp"
#include "registry.hpp"
#include "section.hpp"
#include "sheet_text.hpp"
#include "sheets.hpp"
#include "streamed_writer.hpp"

namespace certet::formats {
namespace {

std::filesystem::path sibling(std::filesystem::path file, const char* extension) {
  return file.replace_extension(extension);
}

class TetgenWriter final : public StreamedWriter {
 public:
  TetgenWriter(const std::filesystem::path& file, const MeshSize& size)
      : StreamedWriter(sibling(file, ".node"), size), ele_file_(sibling(file, ".ele")),
        face_file_(sibling(file, ".face")), nodes_(size, tetgen_order), node_(file_, 0), ele_(ele_file_, 0),
        face_(face_file_, 0) {
    // How many there are, the dimension or the corners, attributes, markers.
    node_.append(Line() << size.points << " 3 0 0\n");
    ele_.append(Line() << size.tets << ' ' << nodes_.per_tet() << " 1\n");
    face_.append(Line() << face_count(survey()) << " 1\n");
  }

 private:
  void put_points(std::uint64_t first, std::span<const Point3> points) override {
    for (const Point3& p : points)
      node_.append(Line() << ++first << ' ' << p[0] << ' ' << p[1] << ' ' << p[2] << '\n');
  }
  void put_tets(std::uint64_t first, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override {
    for (std::size_t i = 0; i < tets.size(); ++i) {
      Line line;
      line << first + i + 1;
      for (const std::uint64_t point : nodes_.tet(tets[i])) line << ' ' << point + 1;
      ele_.append(line << ' ' << labels[i] << '\n');
    }
  }
  void close() override {
    std::uint64_t number = 0;
    Sheets::for_each_face(survey(), [&](const BoundaryFace& face, std::int32_t sheet) {
      const auto& [a, b, c] = face.points;
      face_.append(Line() << ++number << ' ' << a + 1 << ' ' << b + 1 << ' ' << c + 1 << ' ' << sheet
                        << '\n');
    });
    for (Section* section : {&node_, &ele_, &face_}) section->flush();
  }

  /// All three are whole on the disk before the first one takes its name.
  void commit() override { commit_together(std::array{&file_, &ele_file_, &face_file_}); }

  OutputFile ele_file_, face_file_;
  ElementNodes nodes_;
  Section node_, ele_, face_;
};

}  // namespace

std::unique_ptr<MeshWriter> open_tetgen(const std::filesystem::path& file,
                                        const MeshSize& size) {
  return std::make_unique<TetgenWriter>(file, size);
}

std::uint64_t tetgen_bytes(const MeshSize& size) {
  const std::uint64_t digits = digits_of(size.points), tet_digits = digits_of(size.tets);
  const SheetText text(survey_of(size), NameRule::quoted);
  return 100 + size.points * (digits + 60 + 4) +
         size.tets * (tet_digits + ElementNodes(size).per_tet() * (digits + 1) + 2) + text.label_digits +
         text.faces * (digits_of(text.faces) + 3 * (digits + 1) + 2) + text.number_digits;
}

}  // namespace certet::formats
