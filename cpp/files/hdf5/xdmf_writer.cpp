// XDMF 3: a grid of the tetrahedra in NAME.xdmf and one of the triangles of all patches and
// interfaces in NAME_surfaces.xdmf, on the same points; all numbers in NAME.h5.  Two files, for there
// are readers that take one grid of each.

#include <optional>

#include "files/formats/names.hpp"
#include "files/formats/registry.hpp"
#include "files/formats/sheets.hpp"
#include "files/formats/streamed_writer.hpp"
#include "hdf5_file.hpp"

namespace certet::formats {
namespace {

std::filesystem::path with_ending(const std::filesystem::path& file, const char* ending) {
  return file.parent_path() / file.stem().concat(ending);
}
std::filesystem::path surfaces_beside(const std::filesystem::path& file) {
  return with_ending(file, "_surfaces.xdmf");
}
std::filesystem::path numbers_beside(const std::filesystem::path& file) {
  return with_ending(file, ".h5");
}

/// A comment, for there are readers that take other elements for damage.
std::string said(const std::string& thing, std::string what) {
  for (std::size_t at = 0; (at = what.find("--", at)) != std::string::npos;) what.insert(++at, 1, ' ');
  return "    <!-- " + thing + what + " -->\n";
}

/// The .xdmf files: what the arrays of the .h5 file are.
class Description {
 public:
  Description(const MeshSize& size, const std::string& numbers)
      : size_(size), survey_(survey_of(size)), numbers_(escaped_xml(numbers)) {}

  [[nodiscard]] std::string of_mesh() const {
    std::string text = head + "  <Grid Name=\"mesh\" GridType=\"Uniform\">\n";
    if (!size_.space.empty()) text += said("SPACE=", size_.space);
    const std::vector<std::string> names = names_of(survey_.regions, NameRule::xml);
    for (std::size_t i = 0; i < names.size(); ++i)
      text += said("label " + std::to_string(survey_.regions[i].label) + " is ", names[i]);
    text += geometry() + (size_.middles == nullptr
                             ? topology("Tetrahedron", size_.tets, 4, "topology")
                             : topology("Tetrahedron_10", size_.tets, 10, "topology"));
    text += attribute("label", size_.tets);
    return text + tail;
  }

  [[nodiscard]] std::string of_surfaces() const {
    std::string text = head + "  <Grid Name=\"surfaces\" GridType=\"Uniform\">\n";
    const Sheets sheets(survey_, NameRule::xml);
    for (const Sheet& sheet : sheets.all())
      text += said("surface " + std::to_string(sheet.number) + " is ", sheet.name);
    const std::uint64_t faces = face_count(survey_);
    text += geometry() + (size_.middles == nullptr
                             ? topology("Triangle", faces, 3, "surface_topology")
                             : topology("Triangle_6", faces, 6, "surface_topology"));
    return text + attribute("surface", faces) + tail;
  }

 private:
  inline static const std::string head =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n";
  inline static const std::string tail = "  </Grid>\n</Domain>\n</Xdmf>\n";

  [[nodiscard]] std::string geometry() const {
    return "    <Geometry GeometryType=\"XYZ\">\n" +
           item("Float", 8, std::to_string(size_.points) + " 3", "geometry") + "    </Geometry>\n";
  }
  [[nodiscard]] std::string topology(const std::string& type, std::uint64_t cells, int corners,
                                     const std::string& array) const {
    return "    <Topology TopologyType=\"" + type + "\" NumberOfElements=\"" +
           std::to_string(cells) + "\" NodesPerElement=\"" + std::to_string(corners) + "\">\n" +
           item("Int", 8, std::to_string(cells) + " " + std::to_string(corners), array) +
           "    </Topology>\n";
  }
  [[nodiscard]] std::string attribute(const std::string& name, std::uint64_t cells) const {
    return "    <Attribute Name=\"" + name + "\" AttributeType=\"Scalar\" Center=\"Cell\">\n" +
           item("Int", 4, std::to_string(cells), name) + "    </Attribute>\n";
  }
  [[nodiscard]] std::string item(const std::string& type, int bytes, const std::string& dimensions,
                                 const std::string& array) const {
    return "      <DataItem Format=\"HDF\" NumberType=\"" + type + "\" Precision=\"" +
           std::to_string(bytes) + "\" Dimensions=\"" + dimensions + "\">" + numbers_ + ":/" +
           array + "</DataItem>\n";
  }

  const MeshSize& size_;
  const Survey& survey_;
  std::string numbers_;  ///< the name of the .h5 file
};

class XdmfWriter final : public StreamedWriter {
 public:
  XdmfWriter(const std::filesystem::path& file, const MeshSize& size)
      : StreamedWriter(file, size), surfaces_file_(surfaces_beside(file)),
        numbers_file_(numbers_beside(file)), nodes_(size), hdf5_(numbers_file_),
        points_(hdf5_.make_dataset<double>("geometry", size.points, 3)),
        tets_(hdf5_.make_dataset<std::int64_t>("topology", size.tets, nodes_.per_tet())),
        labels_(hdf5_.make_dataset<std::int32_t>("label", size.tets)) {
    const Description description(size_, numbers_beside(file).filename().string());
    put_text(file_, description.of_mesh());
    put_text(surfaces_file_, description.of_surfaces());
    put_surfaces();
  }

 private:
  static void put_text(OutputFile& file, const std::string& text) {
    file.write_at(0, std::as_bytes(std::span(text)));
  }

  void put_points(std::uint64_t, std::span<const Point3> points) override {
    points_->append(points);
  }

  void put_tets(std::uint64_t, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override {
    tets_->append(tets, nodes_);
    labels_->append(labels);
  }

  void put_surfaces() {
    const std::uint64_t faces = face_count(survey());
    auto topology = hdf5_.make_dataset<std::int64_t>("surface_topology", faces, nodes_.per_face());
    auto sheets = hdf5_.make_dataset<std::int32_t>("surface", faces);
    std::vector<std::int64_t> points;
    std::vector<std::int32_t> numbers;
    const auto put = [&] {
      topology.append(std::span<const std::int64_t>(points));
      sheets.append(std::span<const std::int32_t>(numbers));
      points.clear(), numbers.clear();
    };
    constexpr std::size_t at_once = 4096;
    Sheets::for_each_face(survey(), [&](const BoundaryFace& face, std::int32_t sheet) {
      const std::span<const std::uint64_t> own = nodes_.face(face.points);
      points.insert(points.end(), own.begin(), own.end());
      numbers.push_back(sheet);
      if (numbers.size() == at_once) put();
    });
    put();
  }

  void close() override {
    for (auto* dataset : {&points_, &tets_}) dataset->reset();
    labels_.reset();
    hdf5_.close();
  }

  /// All are whole on the disk before the first one takes its name.
  void commit() override {
    commit_together(std::array{&numbers_file_, &surfaces_file_, &file_});
  }

  OutputFile surfaces_file_, numbers_file_;
  ElementNodes nodes_;
  hdf5::File hdf5_;
  std::optional<hdf5::Dataset> points_, tets_, labels_;
};

}  // namespace

std::unique_ptr<MeshWriter> open_xdmf(const std::filesystem::path& file, const MeshSize& size) {
  return std::make_unique<XdmfWriter>(file, size);
}

std::uint64_t xdmf_bytes(const MeshSize& size) {
  const std::uint64_t faces = face_count(survey_of(size));
  const Description description(size, "");
  const ElementNodes nodes(size);
  return 4096 + description.of_mesh().size() + description.of_surfaces().size() + 24 * size.points +
         (8 * nodes.per_tet() + 4) * size.tets + (8 * nodes.per_face() + 4) * faces;
}

}  // namespace certet::formats
