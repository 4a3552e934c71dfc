// VTK XML surfaces, for ParaView beside the .vtu file: the boundary and all interfaces, each
// triangle with the number of its sheet, its region and the one behind it; the sheets' names
// and the frame are field data.

#include <limits>

#include "registry.hpp"
#include "section.hpp"
#include "sheets.hpp"
#include "surface_writer.hpp"
#include "vtu_layout.hpp"

namespace certet::formats {
namespace {

/// Behind the boundary is no region.
constexpr std::int32_t outside = 0;

/// A text as VTK has it in words: its bytes, and a zero behind them.
std::string bytes_in_words(std::string_view text) {
  std::string words;
  for (const char c : text) words += std::to_string(static_cast<unsigned char>(c)) + " ";
  return words + "0 ";
}

std::string text_array(std::string_view name, const std::vector<std::string>& texts) {
  std::string words;
  for (const std::string& text : texts) words += bytes_in_words(text);
  return "      <Array type=\"String\" Name=\"" + std::string(name) + "\" NumberOfTuples=\"" +
         std::to_string(texts.size()) + "\" format=\"ascii\">" + words + "</Array>\n";
}

/// 3D Slicer looks for the frame there, and takes a file without one for LPS.
std::string field_data_of(const MeshSize& size, const Sheets& sheets) {
  std::string numbers;
  std::vector<std::string> names;
  for (const Sheet& sheet : sheets.all()) {
    numbers += std::to_string(sheet.number) + " ";
    names.push_back(sheet.name);
  }
  return "    <FieldData>\n" + (size.space.empty() ? "" : text_array("SPACE", {size.space})) +
         "      <DataArray type=\"Int32\" Name=\"surface_numbers\" NumberOfTuples=\"" +
         std::to_string(names.size()) + "\" format=\"ascii\">" + numbers + "</DataArray>\n" +
         text_array("surface_names", names) + "    </FieldData>\n";
}

class VtpWriter final : public SurfaceWriter {
 public:
  VtpWriter(const std::filesystem::path& file, const MeshSize& size)
      : SurfaceWriter(file, size, true), out_(file_, 0) {
    if (3 * face_count(survey()) > std::uint64_t{std::numeric_limits<std::int32_t>::max()})
      file_.fail("its surfaces have more corners than 32 bits count");
  }

 private:
  void close() override {
    const std::uint64_t faces = face_count(survey());
    out_.append_text(header(faces));
    open(kept().size() * sizeof(Point3));
    out_.append_all(std::span<const Point3>(kept()));
    put(3 * faces, [&](const auto& add) {
      Sheets::for_each_face(survey(), [&](const BoundaryFace& face, std::int32_t) {
        for (const std::uint64_t point : face.points) add(static_cast<std::int32_t>(rank(point)));
      });
    });
    put(faces, [&](const auto& add) {
      for (std::uint64_t i = 1; i <= faces; ++i) add(static_cast<std::int32_t>(3 * i));
    });
    put_sheets(faces);
    out_.append_text("\n  </AppendedData>\n</VTKFile>\n");
    out_.flush();
  }

  /// The numbers of the sheets, the regions, and what is behind.
  void put_sheets(std::uint64_t faces) {
    put(faces, [&](const auto& add) {
      Sheets::for_each_face(survey(), [&](const BoundaryFace&, std::int32_t n) { add(n); });
    });
    put(faces, [&](const auto& add) {
      Sheets::for_each_face(survey(), [&](const BoundaryFace& face, std::int32_t) { add(face.label); });
    });
    put(faces, [&](const auto& add) {
      for (std::size_t i = 0; i < survey().boundary.size(); ++i) add(outside);
      for (const Interface& interface : survey().interfaces)
        for (std::size_t i = 0; i < interface.faces.size(); ++i) add(interface.labels[1]);
    });
  }

  void open(std::uint64_t bytes) { out_.append_all(std::span<const std::uint64_t>(&bytes, 1)); }

  /// An array of numbers of 32 bits, which `generate` hands to what it is given.
  template <class Generate>
  void put(std::uint64_t count, const Generate& generate) {
    open(count * sizeof(std::int32_t));
    generate([this](std::int32_t number) { out_.append_all(std::span<const std::int32_t>(&number, 1)); });
  }

  [[nodiscard]] std::string header(std::uint64_t faces) const {
    std::uint64_t offset = 0;
    const auto array = [&](std::string_view name, std::uint64_t bytes, std::string_view type,
                           std::string_view more = "") {
      std::string tag = "        <DataArray type=\"";
      tag.append(type).append("\" Name=\"").append(name).append("\"").append(more);
      tag += " format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
      offset += sizeof(std::uint64_t) + bytes;
      return tag;
    };
    const auto integers = [&](std::string_view name, std::uint64_t count) {
      return array(name, count * sizeof(std::int32_t), "Int32");
    };
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"";
    text.append(vtu_byte_order).append("\" header_type=\"UInt64\">\n  <PolyData>\n");
    text += field_data_of(size_, Sheets(survey(), NameRule::quoted));
    text += "    <Piece NumberOfPoints=\"" + std::to_string(kept().size()) +
            "\" NumberOfPolys=\"" + std::to_string(faces) + "\">\n      <Points>\n";
    // One after the other: each is placed behind those before it.
    text += array("Points", kept().size() * sizeof(Point3), "Float64", " NumberOfComponents=\"3\"");
    text += "      </Points>\n      <Polys>\n";
    text += integers("connectivity", 3 * faces);
    text += integers("offsets", faces);
    text += "      </Polys>\n      <CellData Scalars=\"surface\">\n";
    for (const std::string_view name : {"surface", "label", "behind"}) text += integers(name, faces);
    return text + "      </CellData>\n    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n_";
  }

  Section out_;
};

}  // namespace

std::unique_ptr<MeshWriter> open_vtp(const std::filesystem::path& file, const MeshSize& size) {
  return std::make_unique<VtpWriter>(file, size);
}

std::uint64_t vtp_bytes(const MeshSize& size) {
  // Points, of which there are half as many as triangles, and seven numbers for each of those.
  const Survey& survey = survey_of(size);
  const std::uint64_t faces = face_count(survey);
  return 1300 + field_data_of(size, Sheets(survey, NameRule::quoted)).size() +
         faces / 2 * sizeof(Point3) + 7 * sizeof(std::int32_t) * faces;
}

}  // namespace certet::formats
