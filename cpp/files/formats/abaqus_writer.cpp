// Abaqus input: nodes, an element set for each region, a surface for each patch and interface.

#include "element_nodes.hpp"
#include "line.hpp"
#include "names.hpp"
#include "region_sections.hpp"
#include "registry.hpp"
#include "sheet_text.hpp"
#include "sheets.hpp"
#include "streamed_writer.hpp"

namespace certet::formats {
namespace {

/// Abaqus has numbers of at most so many characters, and CalculiX drops what is behind them: an
/// exponent, too.
constexpr std::size_t field = 20;

/// Abaqus' number of the face of a C3D4 or C3D10 that does not have a corner.
constexpr std::array<int, 4> face_number{3, 4, 2, 1};

std::string_view element_heading(bool middles) {
  return middles ? "*ELEMENT, TYPE=C3D10, ELSET=" : "*ELEMENT, TYPE=C3D4, ELSET=";
}
constexpr std::string_view surface_heading = "*SURFACE, TYPE=ELEMENT, NAME=";

class AbaqusWriter final : public StreamedWriter {
 public:
  AbaqusWriter(const std::filesystem::path& file, const MeshSize& size)
      : StreamedWriter(file, size), nodes_(size), text_(file_, 0), tets_(file_),
        tet_digits_(digits_of(size.tets)), point_digits_(digits_of(size.points)) {
    text_.append_text("*HEADING\nTetrahedra by certet\n*NODE\n");
    static_cast<void>(survey());
  }

 private:
  /// "number, a, b, c, d" and the end of the line.
  [[nodiscard]] std::uint64_t line_bytes() const {
    return tet_digits_ + nodes_.per_tet() * (2 + point_digits_) + 1;
  }

  void put_points(std::uint64_t first, std::span<const Point3> points) override {
    for (const Point3& p : points)
      text_.append_all(
          (Line() << ++first << ", " << Field{p[0], field} << ", " << Field{p[1], field} << ", "
                  << Field{p[2], field} << '\n')
              .text());
  }

  void open_tets() override {
    text_.flush();
    std::uint64_t end = text_.end();
    const std::vector<std::string> names = names_of(survey().regions, NameRule::identifier);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string heading = std::string(element_heading(nodes_.has_middles())) + names[i] + "\n";
      end = tets_.open(survey().regions[i], end, std::as_bytes(std::span(heading)),
                       line_bytes());
    }
    text_ = {file_, end};
  }

  void put_tets(std::uint64_t first, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override {
    for (std::size_t i = 0; i < tets.size(); ++i) {
      Line line;
      line << Padded{first + i + 1, tet_digits_};
      for (const std::uint64_t point : nodes_.tet(tets[i])) line << ", " << Padded{point + 1, point_digits_};
      tets_.append(labels[i], std::as_bytes((line << '\n').text()));
    }
  }

  void close() override {
    tets_.flush();
    const Sheets sheets(survey(), NameRule::identifier);
    for (const Sheet& sheet : sheets.all()) {
      text_.append_all((Line() << surface_heading << sheet.name << '\n').text());
      sheets.for_each_face(sheet, [&](const BoundaryFace& face) {
        text_.append_all(
            (Line() << face.tet + 1 << ", S" << face_number[face.opposite] << '\n').text());
      });
    }
    text_.flush();
  }

  ElementNodes nodes_;
  Section text_;
  RegionSections tets_;
  std::size_t tet_digits_, point_digits_;
};

}  // namespace

std::unique_ptr<MeshWriter> open_abaqus(const std::filesystem::path& file,
                                        const MeshSize& size) {
  return std::make_unique<AbaqusWriter>(file, size);
}

std::uint64_t abaqus_bytes(const MeshSize& size) {
  const std::uint64_t point_digits = digits_of(size.points), tet_digits = digits_of(size.tets);
  const SheetText text(survey_of(size), NameRule::identifier);
  return 200 + size.points * (point_digits + 63 + 3) +
         size.tets * (tet_digits + ElementNodes(size).per_tet() * (2 + point_digits) + 1) +
         text.regions * (element_heading(size.middles != nullptr).size() + 1) + text.region_names +
         text.sheets * (surface_heading.size() + 1) + text.sheet_names +
         text.faces * (tet_digits + 5);
}

}  // namespace certet::formats
