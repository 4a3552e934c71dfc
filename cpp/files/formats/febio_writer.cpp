// FEBio 4.0: the mesh, with a part for each region and a surface for each patch and interface.
// Materials and all else are for the user to add.

#include <utility>

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

constexpr std::string_view head =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<febio_spec version=\"4.0\">\n"
    "  <Module type=\"solid\"/>\n"
    "  <Mesh>\n"
    "    <Nodes name=\"points\">\n";
constexpr std::string_view part_end = "    </Elements>\n";
/// What is around the name of a part, and of a surface, its end included.
constexpr std::uint64_t part_frame = 35 + part_end.size(), surface_frame = 23 + 15;

class FebioWriter final : public StreamedWriter {
 public:
  FebioWriter(const std::filesystem::path& file, const MeshSize& size)
      : StreamedWriter(file, size), nodes_(size), text_(file_, 0), tets_(file_),
        tet_digits_(digits_of(size.tets)), point_digits_(digits_of(size.points)) {
    static_cast<void>(survey());
    text_.append_text(head);
  }

 private:
  /// <elem id="number">a,b,c,d</elem>
  [[nodiscard]] std::uint64_t line_bytes() const {
    return 20 + tet_digits_ + nodes_.per_tet() * (point_digits_ + 1) - 1;
  }

  void put_points(std::uint64_t first, std::span<const Point3> points) override {
    for (const Point3& p : points)
      text_.append_all((Line() << "<node id=\"" << ++first << "\">" << p[0] << ',' << p[1] << ','
                               << p[2] << "</node>\n")
                           .text());
  }

  void open_tets() override {
    text_.append_text("    </Nodes>\n");
    text_.flush();
    std::uint64_t end = text_.end();
    const std::vector<std::string> names = names_of(survey().regions, NameRule::xml);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string heading = "    <Elements type=\"tet" + std::to_string(nodes_.per_tet()) +
                                  "\" name=\"" + names[i] + "\">\n";
      end = tets_.open(survey().regions[i], end, std::as_bytes(std::span(heading)),
                       line_bytes());
      file_.write_at(end, std::as_bytes(std::span(part_end)));
      end += part_end.size();
    }
    text_ = {file_, end};
  }

  void put_tets(std::uint64_t first, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override {
    for (std::size_t i = 0; i < tets.size(); ++i) {
      Line line;
      line << "<elem id=\"" << Padded{first + i + 1, tet_digits_} << '"';
      char before = '>';
      for (const std::uint64_t point : nodes_.tet(tets[i]))
        line << std::exchange(before, ',') << Padded{point + 1, point_digits_};
      tets_.append(labels[i], std::as_bytes((line << "</elem>\n").text()));
    }
  }

  void close() override {
    tets_.flush();
    const Sheets sheets(survey(), NameRule::xml);
    for (const Sheet& sheet : sheets.all()) put_sheet(sheets, sheet);
    text_.append_text("  </Mesh>\n</febio_spec>\n");
    text_.flush();
  }

  void put_sheet(const Sheets& sheets, const Sheet& sheet) {
    text_.append_all((Line() << "    <Surface name=\"" << sheet.name << "\">\n").text());
    std::uint64_t number = 0;
    sheets.for_each_face(sheet, [&](const BoundaryFace& face) {
      const std::string_view kind = nodes_.has_middles() ? "tri6" : "tri3";
      Line line;
      line << '<' << kind << " id=\"" << ++number << '"';
      char before = '>';
      for (const std::uint64_t point : nodes_.face(face.points))
        line << std::exchange(before, ',') << point + 1;
      text_.append_all((line << "</" << kind << ">\n").text());
    });
    text_.append_text("    </Surface>\n");
  }

  ElementNodes nodes_;
  Section text_;
  RegionSections tets_;
  std::size_t tet_digits_, point_digits_;
};

}  // namespace

std::unique_ptr<MeshWriter> open_febio(const std::filesystem::path& file, const MeshSize& size) {
  return std::make_unique<FebioWriter>(file, size);
}

std::uint64_t febio_bytes(const MeshSize& size) {
  const std::uint64_t point_digits = digits_of(size.points), tet_digits = digits_of(size.tets);
  const SheetText text(survey_of(size), NameRule::xml);
  const ElementNodes nodes(size);
  return 400 + size.points * (point_digits + 60 + 22) +
         size.tets * (tet_digits + nodes.per_tet() * (point_digits + 1) + 21) +
         text.regions * part_frame + text.region_names + text.sheets * surface_frame +
         text.sheet_names + text.faces * (digits_of(text.faces) + nodes.per_face() * (point_digits + 1) + 21);
}

}  // namespace certet::formats
