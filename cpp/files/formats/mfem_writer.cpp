// MFEM mesh v1.0: tetrahedra with their regions, triangles with their patches and interfaces, and
// then the points.

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

class MfemWriter final : public StreamedWriter {
 public:
  MfemWriter(const std::filesystem::path& file, const MeshSize& size)
      : StreamedWriter(file, size), groups_(survey()), latest_(groups_),
        element_(groups_, size.points), tets_(file_, 0), text_(file_, 0) {
    tets_.append_text(heading_of(groups_, size.tets));
    text_ = {file_, tets_.end() + size.tets * element_.bytes()};
    put_boundary();
    text_.append(Line() << "\nvertices\n" << size.points << "\n3\n");
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
    for (const Point3& p : points)
      text_.append(Line() << p[0] << ' ' << p[1] << ' ' << p[2] << '\n');
  }

  void put_tets(std::uint64_t, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override {
    for (std::size_t i = 0; i < tets.size(); ++i) {
      const auto attribute = static_cast<std::uint64_t>(latest_.number_of(labels[i], file_));
      Line line;
      line << Padded{attribute, element_.attribute_digits} << ' ' << mfem_tetrahedron;
      for (const std::uint64_t point : tets[i]) line << ' ' << Padded{point, element_.point_digits};
      tets_.append_all((line << '\n').text());
    }
  }

  void close() override {
    tets_.flush();
    text_.flush();
  }

  NumberedGroups groups_;
  LatestGroup latest_;
  ElementLine element_;
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
  return heading_of(groups, size.tets).size() + size.tets * ElementLine(groups, size.points).bytes() +
         text.faces * (2 + 3 * (1 + digits_of(size.points)) + 1) + text.number_digits + 60 +
         size.points * 60;
}

std::vector<std::string> mfem_label_losses(const Survey& survey) {
  return told_of_labels(survey, "MFEM's attributes are numbered from 1",
                        "a comment in the file has its name");
}

}  // namespace certet::formats
