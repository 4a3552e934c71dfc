// LS-DYNA keywords: nodes, solid elements, of ten nodes too, in a part for each region, and for each patch and
// interface the set of its nodes and that of its segments.  Materials and the rest are for the user
// to add: the material of a part has the part's number.

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

/// One section for all parts: tetrahedra with one point of integration, or those of ten nodes.
std::string_view dyna_head(bool middles) {
  return middles
             ? "*KEYWORD\n*TITLE\nTetrahedra by certet\n*SECTION_SOLID\n         1        16\n*NODE\n"
             : "*KEYWORD\n*TITLE\nTetrahedra by certet\n*SECTION_SOLID\n         1        10\n*NODE\n";
}
constexpr std::size_t dyna_field = 8, dyna_real = 16, dyna_card = 10;
constexpr std::uint64_t node_bytes = dyna_field + 3 * dyna_real + 1,
                        element_bytes = 10 * dyna_field + 1,
                        heading_bytes = 2 * dyna_field + 1,  // of an element of ten nodes
                        segment_bytes = 4 * dyna_card + 1;

class DynaWriter final : public StreamedWriter {
 public:
  DynaWriter(const std::filesystem::path& file, const MeshSize& size)
      : StreamedWriter(file, size), groups_(survey(), greatest_of_8_digits, NameRule::title), latest_(groups_),
        nodes_(size), text_(file_, 0) {
    if (std::max(size.points, size.tets) > greatest_of_8_digits)
      file_.fail("LS-DYNA's fields hold numbers up to 99,999,999");
    text_.append_text(dyna_head(nodes_.has_middles()));
  }

 private:
  void put_fields(std::size_t width, std::initializer_list<std::uint64_t> numbers) {
    text_.append(Line() << PaddedAll{numbers, width} << '\n');
  }

  void put_points(std::uint64_t first, std::span<const Point3> points) override {
    for (const Point3& p : points) {
      const std::array<std::string, 3> text = fields_.fields(p);
      Line line;
      line << Padded{++first, dyna_field};
      for (const std::string& number : text)
        line << std::string(dyna_real - number.size(), ' ') << number;
      text_.append(line << '\n');
    }
  }

  void open_tets() override {
    fields_.finish(file_);
    text_.append_text("*ELEMENT_SOLID\n");
  }

  /// A tetrahedron of four nodes is a brick whose fourth corner is there five times; one of ten has
  /// them in a line of their own.
  void put_tets(std::uint64_t first, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override {
    for (std::size_t i = 0; i < tets.size(); ++i) {
      const auto part = static_cast<std::uint64_t>(latest_.number_of(labels[i], file_));
      const std::span<const std::uint64_t> nodes = nodes_.tet(tets[i]);
      Line line;
      line << Padded{first + i + 1, dyna_field} << Padded{part, dyna_field};
      if (nodes_.has_middles()) line << '\n';
      for (const std::uint64_t node : nodes) line << Padded{node + 1, dyna_field};
      for (std::size_t n = nodes.size(); n < 8; ++n) line << Padded{nodes.back() + 1, dyna_field};
      text_.append(line << '\n');
    }
  }

  void close() override {
    for (const NumberedGroups::Group& region : groups_.regions) {
      const auto number = static_cast<std::uint64_t>(region.number);
      text_.append_text("*PART\n" + region.name + "\n");
      put_fields(dyna_card, {number, 1, number});
    }
    for (const Sheet& sheet : groups_.sheets.all()) {
      put_points_of(sheet);
      put_segments_of(sheet);
    }
    text_.append_text("*END\n");
    text_.flush();
  }

  void open_set(std::string_view keyword, const Sheet& sheet) {
    text_.append_text(keyword);
    text_.append_text(sheet.name + "\n");
    put_fields(dyna_card, {static_cast<std::uint64_t>(sheet.number)});
  }

  void put_points_of(const Sheet& sheet) {
    constexpr std::size_t in_line = 8;
    open_set("*SET_NODE_LIST_TITLE\n", sheet);
    const std::vector<std::uint64_t> points = nodes_of(groups_.sheets, sheet, nodes_);
    for (std::size_t i = 0; i < points.size(); i += in_line) {
      Line line;
      for (std::size_t j = i; j < std::min(i + in_line, points.size()); ++j)
        line << Padded{points[j] + 1, dyna_card};
      text_.append(line << '\n');
    }
  }

  /// A triangle is a segment whose last node is there twice; the corners alone are told.
  void put_segments_of(const Sheet& sheet) {
    open_set("*SET_SEGMENT_TITLE\n", sheet);
    groups_.sheets.for_each_face(sheet, [&](const BoundaryFace& face) {
      const auto& [a, b, c] = face.points;
      put_fields(dyna_card, {a + 1, b + 1, c + 1, c + 1});
    });
  }

  NumberedGroups groups_;
  LatestGroup latest_;
  ElementNodes nodes_;
  Fields16 fields_;
  Section text_;
};

}  // namespace

std::unique_ptr<MeshWriter> open_dyna(const std::filesystem::path& file, const MeshSize& size) {
  return std::make_unique<DynaWriter>(file, size);
}

std::uint64_t dyna_bytes(const MeshSize& size) {
  const SheetText text(survey_of(size), NameRule::title);
  const bool middles = size.middles != nullptr;
  // A surface has half as many points as triangles, and one and a half times as many edges.
  return dyna_head(middles).size() + 25 + size.points * node_bytes +
         size.tets * (element_bytes + (middles ? heading_bytes : 0)) +
         text.regions * 38 + text.region_names + text.sheets * 63 + 2 * text.sheet_names +
         text.faces * segment_bytes + text.faces / 2 * (middles ? 4 : 1) * (dyna_card + 1);
}

std::vector<std::string> dyna_label_losses(const Survey& survey) {
  return told_of_labels(survey, "LS-DYNA's parts have numbers of up to 8 digits",
                        "the part's title is the region's name", greatest_of_8_digits);
}

}  // namespace certet::formats
