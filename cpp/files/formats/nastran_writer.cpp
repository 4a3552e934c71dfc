// Nastran bulk data: GRID points, CTETRA elements, of ten nodes too, with a PSOLID property for each region, and a
// SET1 of the points of each patch and interface.  Materials, loads and the rest are for the user
// to add: the material of a region has the region's number.

#include <algorithm>

#include "element_nodes.hpp"
#include "field16.hpp"
#include "line.hpp"
#include "numbered_groups.hpp"
#include "registry.hpp"
#include "section.hpp"
#include "sheet_points.hpp"
#include "sheet_text.hpp"
#include "streamed_writer.hpp"

namespace certet::formats {
namespace {

constexpr std::string_view nastran_head =
    "$ Tetrahedra by certet.  The material of each property, which has its number, is yours to add.\n"
    "BEGIN BULK\n";
constexpr std::size_t nastran_field = 8, nastran_wide = 16;
constexpr std::size_t nodes_in_line = 6;  ///< of CTETRA
/// GRID* and its continuation; CTETRA; PSOLID with a comment, without the name.
constexpr std::uint64_t grid_bytes = (8 + 4 * nastran_wide + 1) + (8 + nastran_wide + 1),
                        tetra_bytes = 7 * nastran_field + 1,
                        more_bytes = 7 * nastran_field + 1,  // of its continuation
                        solid_bytes = 3 * nastran_field + 1 + 12;

class NastranWriter final : public StreamedWriter {
 public:
  NastranWriter(const std::filesystem::path& file, const MeshSize& size)
      : StreamedWriter(file, size), groups_(survey(), greatest_of_8_digits), latest_(groups_),
        nodes_(size), text_(file_, 0) {
    if (std::max(size.points, size.tets) > greatest_of_8_digits)
      file_.fail("Nastran's fields hold numbers up to 99,999,999");
    text_.append_text(nastran_head);
    for (const NumberedGroups::Group& region : groups_.regions) {
      text_.append_text("$ region " + region.name + "\n");
      const auto number = static_cast<std::uint64_t>(region.number);
      put_card("PSOLID", {number, number});
    }
  }

 private:
  void put_card(std::string_view name, std::initializer_list<std::uint64_t> numbers) {
    Line line;
    line << name;
    for (std::size_t i = name.size(); i < nastran_field; ++i) line << ' ';
    text_.append(line << PaddedAll{numbers, nastran_field} << '\n');
  }

  void put_points(std::uint64_t first, std::span<const Point3> points) override {
    for (const Point3& p : points) {
      const std::array<std::string, 3> text = fields_.fields(p);
      Line line;
      line << "GRID*   " << Padded{++first, nastran_wide} << std::string(nastran_wide, ' ');
      put_field(line, text[0]);
      put_field(line, text[1]);
      line << "\n*       ";
      put_field(line, text[2]);
      text_.append(line << '\n');
    }
  }
  static void put_field(Line& line, const std::string& text) {
    line << std::string(nastran_wide - text.size(), ' ') << text;
  }

  void open_tets() override { fields_.finish(file_); }

  void put_tets(std::uint64_t first, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override {
    for (std::size_t i = 0; i < tets.size(); ++i) {
      const auto property = static_cast<std::uint64_t>(latest_.number_of(labels[i], file_));
      const std::span<const std::uint64_t> nodes = nodes_.tet(tets[i]);
      Line line;
      line << "CTETRA  " << Padded{first + i + 1, nastran_field} << Padded{property, nastran_field};
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (n == nodes_in_line) line << "\n+       ";
        line << Padded{nodes[n] + 1, nastran_field};
      }
      text_.append(line << '\n');
    }
  }

  void close() override {
    for (const Sheet& sheet : groups_.sheets.all()) put_points_of(sheet);
    text_.append_text("ENDDATA\n");
    text_.flush();
  }

  /// Eight fields to a line; the first one has the set's number in its first field.
  void put_points_of(const Sheet& sheet) {
    constexpr std::size_t fields = 8;
    text_.append_text("$ points of " + sheet.name + "\n");
    std::vector<std::uint64_t> numbers{static_cast<std::uint64_t>(sheet.number)};
    for (const std::uint64_t point : nodes_of(groups_.sheets, sheet, nodes_)) numbers.push_back(point + 1);
    for (std::size_t i = 0; i < numbers.size(); i += fields) {
      Line line;
      line << (i == 0 ? "SET1    " : "+       ");
      const auto few = std::span(numbers).subspan(i, std::min(fields, numbers.size() - i));
      text_.append(line << PaddedAll{few, nastran_field} << '\n');
    }
  }

  NumberedGroups groups_;
  LatestGroup latest_;
  ElementNodes nodes_;
  Fields16 fields_;
  Section text_;
};

}  // namespace

std::unique_ptr<MeshWriter> open_nastran(const std::filesystem::path& file,
                                         const MeshSize& size) {
  return std::make_unique<NastranWriter>(file, size);
}

std::uint64_t nastran_bytes(const MeshSize& size) {
  const Survey& survey = survey_of(size);
  const SheetText text(survey, NameRule::quoted);
  const bool middles = size.middles != nullptr;
  // A surface has half as many points as triangles, and one and a half times as many edges.
  return nastran_head.size() + size.points * grid_bytes + size.tets * (tetra_bytes + (middles ? more_bytes : 0)) +
         text.regions * solid_bytes + text.region_names + text.sheets * (12 + 2 * nastran_field + 10) +
         text.sheet_names + text.faces / 2 * (middles ? 4 : 1) * (nastran_field + 2) + 8;
}

std::vector<std::string> nastran_label_losses(const Survey& survey) {
  return told_of_labels(survey, "Nastran's properties have numbers of up to 8 digits",
                        "a comment in the file has its name", greatest_of_8_digits);
}

}  // namespace certet::formats
