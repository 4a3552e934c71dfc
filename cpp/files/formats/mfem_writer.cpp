// MFEM mesh v1.0: tetrahedra with their regions, triangles with their patches and interfaces, and
// then the points, or the ten nodes of each tetrahedron.

#include <array>
#include <string_view>
#include <vector>

#include "certet/middle_nodes.hpp"
#include "line.hpp"
#include "numbered_groups.hpp"
#include "registry.hpp"
#include "section.hpp"
#include "sheet_text.hpp"
#include "streamed_writer.hpp"

namespace certet::formats {
namespace {

/// MFEM's numbers of shapes.
constexpr int mfem_triangle = 2, mfem_tetrahedron = 4;

/// The ten nodes of an element, two of which two corners have between them, one the other: by growing
/// multiples of a half along its third edge from the first corner, then its second, then its first.
constexpr std::array<std::array<std::uint8_t, 2>, 10> mfem_nodes{
    {{0, 0}, {0, 1}, {1, 1}, {0, 2}, {1, 2}, {2, 2}, {0, 3}, {1, 3}, {2, 3}, {3, 3}}};

/// Each element has its own nodes, so that none is named by an edge, which only MFEM numbers; those of
/// two elements side by side are at the same places.
constexpr std::string_view l2_heading =
    "\nnodes\nFiniteElementSpace\nFiniteElementCollection: L2_T1_3D_P2\nVDim: 3\nOrdering: 1\n\n";

/// What is known before the first number, names in comments too.
std::string heading_of(const NumberedGroups& groups, std::uint64_t tets) {
  std::string text = "MFEM mesh v1.0\n\n# Tetrahedra by certet\n";
  for (const NumberedGroups::Group& region : groups.regions)
    text += "# attribute " + std::to_string(region.number) + " is " + region.name + "\n";
  for (const Sheet& sheet : groups.sheets.all())
    text += "# boundary attribute " + std::to_string(sheet.number) + " is " + sheet.name + "\n";
  return text + "\ndimension\n3\n\nelements\n" + std::to_string(tets) + "\n";
}

/// An attribute, a shape, corners, all padded to one width, for their place to be known.
struct ElementLine {
  explicit ElementLine(const NumberedGroups& groups, std::uint64_t points)
      : point_digits(digits_of(points)) {
    for (const NumberedGroups::Group& region : groups.regions)
      attribute_digits = std::max(attribute_digits, digits_of(region.number));
  }
  [[nodiscard]] std::uint64_t bytes() const {
    return attribute_digits + 2 + 4 * (1 + point_digits) + 1;
  }
  std::size_t attribute_digits = 1, point_digits;
};

std::uint64_t vertex_count(const MeshSize& size) {
  return size.middles == nullptr ? size.points : size.middles->corners();
}

class MfemWriter final : public StreamedWriter {
 public:
  MfemWriter(const std::filesystem::path& file, const MeshSize& size)
      : StreamedWriter(file, size), groups_(survey()), latest_(groups_),
        element_(groups_, vertex_count(size)), tets_(file_, 0), text_(file_, 0) {
    tets_.append_text(heading_of(groups_, size.tets));
    text_ = {file_, tets_.end() + size.tets * element_.bytes()};
    put_boundary();
    if (size_.middles == nullptr) {
      text_.append(Line() << "\nvertices\n" << size.points << "\n3\n");
    } else {
      text_.append(Line() << "\nvertices\n" << size_.middles->corners() << '\n');
      text_.append_text(l2_heading);
    }
  }

 private:
  void put_boundary() {
    text_.append(Line() << "\nboundary\n" << face_count(survey()) << '\n');
    Sheets::for_each_face(survey(), [&](const BoundaryFace& face, std::int32_t sheet) {
      const auto& [a, b, c] = face.points;
      text_.append(Line() << sheet << ' ' << mfem_triangle << ' ' << a << ' ' << b << ' ' << c << '\n');
    });
  }

  void put_points(std::uint64_t, std::span<const Point3> points) override {
    if (size_.middles != nullptr) {
      points_.insert(points_.end(), points.begin(), points.end());
      return;
    }
    for (const Point3& p : points) put_point(p);
  }

  void put_point(const Point3& p) {
    text_.append(Line() << p[0] << ' ' << p[1] << ' ' << p[2] << '\n');
  }

  void put_nodes(const Tet<std::uint64_t>& tet) {
    for (const auto& [from, to] : mfem_nodes) {
      const std::uint64_t corner = tet[from];
      put_point(points_[from == to ? corner
                                   : size_.middles->corners() + size_.middles->between(corner, tet[to])]);
    }
  }

  void put_tets(std::uint64_t, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override {
    for (std::size_t i = 0; i < tets.size(); ++i) {
      const auto attribute = static_cast<std::uint64_t>(latest_.number_of(labels[i], file_));
      Line line;
      line << Padded{attribute, element_.attribute_digits} << ' ' << mfem_tetrahedron;
      for (const std::uint64_t point : tets[i]) line << ' ' << Padded{point, element_.point_digits};
      tets_.append_all((line << '\n').text());
      if (size_.middles != nullptr) put_nodes(tets[i]);
    }
  }

  void close() override {
    tets_.flush();
    text_.flush();
  }

  NumberedGroups groups_;
  LatestGroup latest_;
  ElementLine element_;
  std::vector<Point3> points_;  ///< where elements have ten nodes
  Section tets_, text_;
};

}  // namespace

std::unique_ptr<MeshWriter> open_mfem(const std::filesystem::path& file, const MeshSize& size) {
  return std::make_unique<MfemWriter>(file, size);
}

std::uint64_t mfem_bytes(const MeshSize& size) {
  const Survey& survey = survey_of(size);
  const NumberedGroups groups(survey);
  const SheetText text(survey, NameRule::quoted);
  const std::uint64_t corners = vertex_count(size);
  const std::uint64_t nodes = size.middles == nullptr ? corners : mfem_nodes.size() * size.tets;
  return heading_of(groups, size.tets).size() + size.tets * ElementLine(groups, corners).bytes() +
         text.faces * (2 + 3 * (1 + digits_of(corners)) + 1) + text.number_digits + 160 + nodes * 60;
}

std::vector<std::string> mfem_label_losses(const Survey& survey) {
  return told_of_labels(survey, "MFEM's attributes are numbered from 1",
                        "a comment in the file has its name");
}

}  // namespace certet::formats
