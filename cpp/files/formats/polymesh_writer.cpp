// OpenFOAM: a folder polyMesh, of ASCII files.  Faces between cells come first, by their owner and
// then their neighbour, and then those of each patch; regions are zones of cells, and interfaces
// zones of faces.

#include <array>
#include <limits>

#include "cell_faces.hpp"
#include "line.hpp"
#include "mesh/boundary.hpp"
#include "names.hpp"
#include "output_folder.hpp"
#include "polymesh_files.hpp"
#include "registry.hpp"
#include "section.hpp"
#include "sheets.hpp"
#include "streamed_writer.hpp"

namespace certet::formats {
namespace {

/// What every file begins with.
std::string header_of(std::string_view type, std::string_view object, std::string_view note = "") {
  std::string text = "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       ";
  text.append(type).append(";\n");
  if (!note.empty()) text.append("    note        \"").append(note).append("\";\n");
  return text.append("    location    \"constant/polyMesh\";\n    object      ")
      .append(object).append(";\n}\n\n");
}

/// A file of the folder, and the text that goes there.
class PolyMeshFile {
 public:
  PolyMeshFile(const OutputFolder& folder, std::string_view name)
      : file_(folder.growing() / name, folder.asked_for()), text_(file_, 0) {}

  PolyMeshFile& operator<<(std::string_view words) {
    text_.append_text(words);
    return *this;
  }
  PolyMeshFile& operator<<(const Line& line) {
    text_.append(line);
    return *this;
  }
  void commit() {
    text_.flush();
    file_.commit();
  }

 private:
  OutputFile file_;
  Section text_;
};

/// The folder is there before, and goes after, the files in it.
class PolyMeshWriter final : private OutputFolder, public StreamedWriter {
 public:
  PolyMeshWriter(const std::filesystem::path& folder, const MeshSize& size)
      : OutputFolder(folder, polymesh_files, "polyMesh"),
        StreamedWriter(growing() / "points", folder, size), text_(file_, 0) {
    constexpr std::uint64_t most = std::numeric_limits<std::int32_t>::max();
    if (size.points > most || 2 * size.tets + survey().boundary.size() > most)
      file_.fail("OpenFOAM's labels hold numbers up to 2,147,483,647");
    text_.append_text(header_of("vectorField", "points"));
    text_.append_all((Line() << size.points << "\n(\n").text());
    tets_.reserve(size.tets);
  }

 private:
  void put_points(std::uint64_t, std::span<const Point3> points) override {
    for (const Point3& p : points)
      text_.append_all((Line() << '(' << p[0] << ' ' << p[1] << ' ' << p[2] << ")\n").text());
  }

  void put_tets(std::uint64_t, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override {
    for (const Tet<std::uint64_t>& tet : tets) {
      Tet<std::uint32_t>& held = tets_.emplace_back();
      for (std::size_t v = 0; v < 4; ++v) held[v] = static_cast<std::uint32_t>(tet[v]);
    }
    labels_.insert(labels_.end(), labels.begin(), labels.end());
  }

  void close() override {
    text_.append_text(")\n");
    text_.flush();
    const CellFaces cells(size_.points, tets_);
    if (!cells.are_cells() || 2 * cells.inner() + survey().boundary.size() != 4 * tets_.size())
      file_.fail("a face is in more than two of its tetrahedra, or one of these is none");
    const Sheets sheets(survey(), NameRule::identifier);
    put_faces(cells, sheets);
    put_owners(cells, sheets);
    put_boundary(cells, sheets);
    put_cell_zones();
    put_face_zones(cells, sheets);
  }

  void commit() override {
    file_.commit();
    publish();
  }

  [[nodiscard]] std::uint64_t face_count_of(const CellFaces& cells) const {
    return cells.inner() + survey().boundary.size();
  }
  [[nodiscard]] std::string note(const CellFaces& cells) const {
    return "nPoints:" + std::to_string(size_.points) + "  nCells:" + std::to_string(tets_.size()) +
           "  nFaces:" + std::to_string(face_count_of(cells)) +
           "  nInternalFaces:" + std::to_string(cells.inner());
  }

  /// Calls visit(face) for the faces of all patches, one after the other.
  template <class Visit>
  void for_each_outer(const Sheets& sheets, const Visit& visit) const {
    for (const Sheet& sheet : sheets.all())
      if (sheets.is_patch(sheet)) sheets.for_each_face(sheet, visit);
  }
  /// Calls visit(tetrahedron, face) for those between two.
  template <class Visit>
  void for_each_inner(const CellFaces& cells, const Visit& visit) const {
    for (std::uint32_t tet = 0; tet < tets_.size(); ++tet)
      cells.for_each_owned(tet, [&](const OwnedFace& face, std::uint64_t) { visit(tet, face); });
  }

  /// Each is seen from its owner's outside, so that its normal leads to the neighbour.
  void put_faces(const CellFaces& cells, const Sheets& sheets) {
    PolyMeshFile file(*this, "faces");
    file << header_of("faceList", "faces") << (Line() << face_count_of(cells) << "\n(\n");
    for_each_inner(cells, [&](std::uint32_t tet, const OwnedFace& face) {
      const auto [a, b, c] = core::outward_faces[face.opposite];
      file << (Line() << "3(" << tets_[tet][a] << ' ' << tets_[tet][b] << ' ' << tets_[tet][c] << ")\n");
    });
    for_each_outer(sheets, [&](const BoundaryFace& face) {
      const auto& [a, b, c] = face.points;
      file << (Line() << "3(" << a << ' ' << b << ' ' << c << ")\n");
    });
    file << ")\n";
    file.commit();
  }

  void put_owners(const CellFaces& cells, const Sheets& sheets) {
    PolyMeshFile owner(*this, "owner"), neighbour(*this, "neighbour");
    owner << header_of("labelList", "owner", note(cells))
          << (Line() << face_count_of(cells) << "\n(\n");
    neighbour << header_of("labelList", "neighbour", note(cells))
              << (Line() << cells.inner() << "\n(\n");
    for_each_inner(cells, [&](std::uint32_t tet, const OwnedFace& face) {
      owner << (Line() << tet << '\n');
      neighbour << (Line() << face.neighbour << '\n');
    });
    for_each_outer(sheets, [&](const BoundaryFace& face) { owner << (Line() << face.tet << '\n'); });
    owner << ")\n";
    neighbour << ")\n";
    owner.commit();
    neighbour.commit();
  }

  void put_boundary(const CellFaces& cells, const Sheets& sheets) {
    PolyMeshFile file(*this, "boundary");
    std::size_t patches = 0;
    for (const Sheet& sheet : sheets.all()) patches += sheets.is_patch(sheet) ? 1 : 0;
    file << header_of("polyBoundaryMesh", "boundary") << (Line() << patches << "\n(\n");
    std::uint64_t first = cells.inner();
    for (const Sheet& sheet : sheets.all()) {
      if (!sheets.is_patch(sheet)) continue;
      file << "    " << sheet.name
           << (Line() << "\n    {\n        type            patch;\n        nFaces          "
                      << sheet.faces << ";\n        startFace       " << first << ";\n    }\n");
      first += sheet.faces;
    }
    file << ")\n";
    file.commit();
  }

  void put_cell_zones() {
    std::vector<std::vector<std::uint32_t>> cells(survey().regions.size());
    std::size_t region = 0;
    for (std::size_t tet = 0; tet < labels_.size(); ++tet) {
      // Labels come in runs.
      if (cells.empty() || survey().regions[region].label != labels_[tet])
        region = region_of(labels_[tet]);
      cells[region].push_back(static_cast<std::uint32_t>(tet));
    }
    PolyMeshFile file(*this, "cellZones");
    file << header_of("regIOobject", "cellZones") << (Line() << cells.size() << "\n(\n");
    const std::vector<std::string> names = names_of(survey().regions, NameRule::identifier);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      file << names[i] << "\n{\n    type cellZone;\n    cellLabels      List<label>\n"
           << (Line() << cells[i].size() << "\n(\n");
      for (const std::uint32_t cell : cells[i]) file << (Line() << cell << '\n');
      file << ")\n;\n}\n";
    }
    file << ")\n";
    file.commit();
  }

  [[nodiscard]] std::size_t region_of(std::int32_t label) const {
    const auto& regions = survey().regions;
    const auto found = std::ranges::lower_bound(regions, label, {}, &Region::label);
    if (found == regions.end() || found->label != label)
      file_.fail("a tetrahedron has a label that was not announced");
    return static_cast<std::size_t>(found - regions.begin());
  }

  /// Interfaces, which are seen from the region of the lesser label: turned where the face's owner
  /// is on the other side.
  void put_face_zones(const CellFaces& cells, const Sheets& sheets) {
    PolyMeshFile file(*this, "faceZones");
    file << header_of("regIOobject", "faceZones")
         << (Line() << survey().interfaces.size() << "\n(\n");
    for (const Sheet& sheet : sheets.all()) {
      if (sheets.is_patch(sheet)) continue;
      std::string places, turned;
      sheets.for_each_face(sheet, [&](const BoundaryFace& face) {
        bool is_owner = true;
        places += std::to_string(cells.place_of(static_cast<std::uint32_t>(face.tet),
                                                face.opposite, is_owner)) + "\n";
        turned += is_owner ? "0\n" : "1\n";
      });
      const std::string count = std::to_string(sheet.faces) + "\n(\n";
      file << sheet.name << "\n{\n    type faceZone;\n    faceLabels      List<label>\n" << count
           << places << ")\n;\n    flipMap         List<bool>\n" << count << turned
           << ")\n;\n}\n";
    }
    file << ")\n";
    file.commit();
  }

  Section text_;
  std::vector<Tet<std::uint32_t>> tets_;
  std::vector<std::int32_t> labels_;
};

}  // namespace

std::unique_ptr<MeshWriter> open_polymesh(const std::filesystem::path& folder,
                                          const MeshSize& size) {
  return std::make_unique<PolyMeshWriter>(folder, size);
}

std::uint64_t polymesh_bytes(const MeshSize& size) {
  const std::uint64_t digits = digits_of(size.points), tet_digits = digits_of(size.tets);
  const Survey& survey = survey_of(size);
  const std::uint64_t outer = survey.boundary.size(), inner = (4 * size.tets - outer) / 2;
  const std::uint64_t faces = inner + outer;
  return 2000 + size.points * (60 + 5) + faces * (3 * digits + 6) +
         (faces + inner) * (tet_digits + 1) + size.tets * (tet_digits + 1) +
         (face_count(survey) - outer) * (tet_digits + 3) + 200 * survey.regions.size();
}

}  // namespace certet::formats
