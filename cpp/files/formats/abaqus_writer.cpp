// Abaqus input: nodes, an element set and a node set for each region, a surface and a node set for
// each patch and interface.  What a solver needs besides, a material and a section for each region,
// is said in comments: the file may be included by one that has its own.

#include <algorithm>

#include "element_nodes.hpp"
#include "line.hpp"
#include "names.hpp"
#include "region_sections.hpp"
#include "registry.hpp"
#include "sheet_points.hpp"
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
constexpr std::string_view set_heading = "*NSET, NSET=";
/// Numbers in a line of a set.
constexpr std::uint64_t numbers_in_line = 16;
constexpr std::string_view material_heading = "** *MATERIAL, NAME=";
constexpr std::string_view elastic = "\n** *ELASTIC\n** E, nu\n";
constexpr std::string_view section_heading = "** *SOLID SECTION, ELSET=", section_material = ", MATERIAL=";

/// Names of the node sets: those of the sheets, and different ones for the regions.
std::vector<std::string> names_of_region_sets(const Survey& survey, const Sheets& sheets) {
  std::vector<Region> all;
  for (const Sheet& sheet : sheets.all()) all.push_back({sheet.number, sheet.name});
  for (const Region& region : survey.regions)
    all.push_back({region.label, region.name.empty() ? default_name(region.label) : region.name});
  std::vector<std::string> names = names_of(all, NameRule::identifier);
  names.erase(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(sheets.all().size()));
  return names;
}

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
    put_sets(sheets);
    for (const Sheet& sheet : sheets.all()) {
      text_.append_all((Line() << surface_heading << sheet.name << '\n').text());
      sheets.for_each_face(sheet, [&](const BoundaryFace& face) {
        text_.append_all(
            (Line() << face.tet + 1 << ", S" << face_number[face.opposite] << '\n').text());
      });
    }
    put_sections();
    text_.flush();
  }

  void put_sets(const Sheets& sheets) {
    for (const Sheet& sheet : sheets.all()) put_set(sheet.name, nodes_of(sheets, sheet, nodes_));
    const std::vector<std::string> names = names_of_region_sets(survey(), sheets);
    std::vector<bool> is_in(size_.points);
    for (std::size_t region = 0; region < names.size(); ++region) {
      std::vector<std::uint64_t> nodes;
      tets_.for_each_record(region, line_bytes(), [&](std::span<const std::byte> record) {
        add_new_nodes(record, is_in, nodes);
      });
      for (const std::uint64_t node : nodes) is_in[node] = false;
      std::ranges::sort(nodes);
      put_set(names[region], nodes);
    }
  }

  /// Those of a line that `line_bytes` describes, which are not in the set yet.
  void add_new_nodes(std::span<const std::byte> record, std::vector<bool>& is_in,
                     std::vector<std::uint64_t>& nodes) const {
    for (std::size_t n = 0; n < nodes_.per_tet(); ++n) {
      std::uint64_t node = 0;
      const std::size_t end = tet_digits_ + (n + 1) * (2 + point_digits_);
      for (const std::byte byte : record.subspan(end - point_digits_, point_digits_))
        if (byte != std::byte{' '}) node = 10 * node + std::to_integer<std::uint64_t>(byte) - '0';
      if (is_in[--node]) continue;
      is_in[node] = true;
      nodes.push_back(node);
    }
  }

  void put_set(std::string_view name, std::span<const std::uint64_t> nodes) {
    text_.append_all((Line() << set_heading << name << '\n').text());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const bool ends = i + 1 == nodes.size() || (i + 1) % numbers_in_line == 0;
      text_.append_all((Line() << nodes[i] + 1 << (ends ? "\n" : ", ")).text());
    }
  }

  void put_sections() {
    for (const std::string& name : names_of(survey().regions, NameRule::identifier))
      text_.append_all((Line() << material_heading << name << elastic << section_heading << name
                               << section_material << name << '\n')
                           .text());
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

namespace {

/// A surface has half as many points as triangles and, of ten nodes, one and a half times as many
/// edges; some points are in several regions.
std::uint64_t sets_bytes(const MeshSize& size, const SheetText& text) {
  const std::uint64_t number = digits_of(size.points) + 2;
  const std::uint64_t of_faces = text.faces / 2 * (size.middles == nullptr ? 1 : 4);
  return number * (size.points + of_faces * (text.regions > 1 ? 2 : 1)) +
         (text.sheets + text.regions) * (set_heading.size() + 1) + text.sheet_names +
         text.region_names + 3 * text.region_names +
         text.regions * (material_heading.size() + elastic.size() + section_heading.size() +
                         section_material.size() + 1);
}

}  // namespace

std::uint64_t abaqus_bytes(const MeshSize& size) {
  const std::uint64_t point_digits = digits_of(size.points), tet_digits = digits_of(size.tets);
  const SheetText text(survey_of(size), NameRule::identifier);
  return 200 + size.points * (point_digits + 63 + 3) +
         size.tets * (tet_digits + ElementNodes(size).per_tet() * (2 + point_digits) + 1) +
         text.regions * (element_heading(size.middles != nullptr).size() + 1) + text.region_names +
         text.sheets * (surface_heading.size() + 1) + text.sheet_names +
         text.faces * (tet_digits + 5) + sets_bytes(size, text);
}

}  // namespace certet::formats
