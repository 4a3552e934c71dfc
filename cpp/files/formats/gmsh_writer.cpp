// Gmsh 4.1, binary.

#include <limits>

#include "certet/bounds.hpp"
#include "element_nodes.hpp"
#include "gmsh_elements.hpp"
#include "gmsh_groups.hpp"
#include "region_sections.hpp"
#include "registry.hpp"
#include "streamed_writer.hpp"

namespace certet::formats {
namespace {

/// The bytes of numbers, one behind the other.
class Bytes {
 public:
  template <class... Numbers>
  Bytes& add(const Numbers&... numbers) {
    (append(std::as_bytes(std::span<const Numbers>(&numbers, 1))), ...);
    return *this;
  }
  Bytes& text(std::string_view text) {
    append(std::as_bytes(std::span(text)));
    return *this;
  }
  [[nodiscard]] std::span<const std::byte> all() const { return bytes_; }

 private:
  void append(std::span<const std::byte> more) {
    bytes_.reserve(bytes_.size() + more.size());
    for (const std::byte byte : more) bytes_.push_back(byte);
  }
  std::vector<std::byte> bytes_;
};

/// Whole numbers of the format: tags and types are `int`, all else is `size_t`.
using Int = std::int32_t;
using Size = std::uint64_t;

constexpr Int surface_dimension = 2, volume_dimension = 3;
/// A number and the nodes.
Size tet_bytes(const ElementNodes& nodes) { return (1 + nodes.per_tet()) * sizeof(Size); }
Size face_bytes(const ElementNodes& nodes) { return (1 + nodes.per_face()) * sizeof(Size); }

/// A surface for each patch and interface, and a volume for each region, none with boundaries of
/// its own.
void add_entities(Bytes& bytes, const GmshGroups& groups, const Bounds& box) {
  const auto add = [&](Int tag) { bytes.add(tag, box.low, box.high, Size{1}, tag, Size{0}); };
  bytes.text("$Entities\n");
  bytes.add(Size{0}, Size{0}, Size{groups.sheets.all().size()}, Size{groups.regions.size()});
  for (const Sheet& sheet : groups.sheets.all()) add(sheet.number);
  for (const GmshGroups::Group& region : groups.regions) add(region.number);
  bytes.text("\n$EndEntities\n");
}

/// Everything before the nodes.  Its length does not depend on the box.
Bytes header_of(const GmshGroups& groups, const Bounds& box) {
  Bytes bytes;
  bytes.text("$MeshFormat\n4.1 1 8\n").add(Int{1}).text("\n$EndMeshFormat\n");
  bytes.text(groups.naming_sections());
  add_entities(bytes, groups, box);
  return bytes;
}

/// All nodes are said to be in the first region.
Bytes nodes_heading(const GmshGroups& groups, Size points) {
  Bytes bytes;
  bytes.text("$Nodes\n");
  const bool any = points > 0 && !groups.regions.empty();
  bytes.add(Size{any ? 1u : 0u}, points, Size{points > 0 ? 1u : 0u}, points);
  if (any) bytes.add(volume_dimension, groups.regions.front().number, Int{0}, points);
  return bytes;
}

Bytes elements_heading(const GmshGroups& groups, Size elements) {
  Bytes bytes;
  bytes.text("\n$EndNodes\n$Elements\n");
  bytes.add(Size{groups.regions.size() + groups.sheets.all().size()}, elements,
            Size{elements > 0 ? 1u : 0u}, elements);
  return bytes;
}

Bytes block_heading(Int dimension, Int tag, Int type, Size elements) {
  Bytes bytes;
  bytes.add(dimension, tag, type, elements);
  return bytes;
}

constexpr std::string_view footer = "\n$EndElements\n";

class GmshWriter final : public StreamedWriter {
 public:
  GmshWriter(const std::filesystem::path& file, const MeshSize& size);

 private:
  void put_points(std::uint64_t first, std::span<const Point3> points) override;
  void open_tets() override;
  void put_tets(std::uint64_t first, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override;
  void close() override;

  /// A number and nodes, both counted from 1.
  std::span<const Size> numbered(Size number, std::span<const Size> nodes);

  GmshGroups groups_;
  ElementNodes nodes_;
  Bounds box_{};  ///< around all points
  std::optional<Section> tags_, coordinates_;
  RegionSections tets_;
  std::uint64_t end_ = 0;  ///< of what has a place in the file
  std::array<Size, 11> record_{};
};

GmshWriter::GmshWriter(const std::filesystem::path& file, const MeshSize& size)
    : StreamedWriter(file, size), groups_(survey()), nodes_(size, gmsh_order), tets_(file_) {
  file_.reserve(gmsh_bytes(size));
  const Bytes heading = nodes_heading(groups_, size.points);
  const std::uint64_t begin = header_of(groups_, box_).all().size();
  file_.write_at(begin, heading.all());
  const std::uint64_t tags_at = begin + heading.all().size();
  tags_.emplace(file_, tags_at);
  coordinates_.emplace(file_, tags_at + size.points * sizeof(Size));
  end_ = tags_at + size.points * (sizeof(Size) + sizeof(Point3));
}

void GmshWriter::put_points(std::uint64_t first, std::span<const Point3> points) {
  if (first == 0 && !points.empty()) box_ = {points[0], points[0]};
  for (const Point3& point : points) {
    const Size tag = ++first;
    tags_->append_all(std::span(&tag, 1));
    for (std::size_t a = 0; a < 3; ++a) {
      box_.low[a] = std::min(box_.low[a], point[a]);
      box_.high[a] = std::max(box_.high[a], point[a]);
    }
  }
  coordinates_->append_all(points);
}

void GmshWriter::open_tets() {
  tags_->flush();
  coordinates_->flush();
  const Bytes elements = elements_heading(groups_, size_.tets + face_count(survey()));
  file_.write_at(end_, elements.all());
  end_ += elements.all().size();
  for (std::size_t i = 0; i < groups_.regions.size(); ++i) {
    const Region& region = survey().regions[i];
    const Bytes heading =
        block_heading(volume_dimension, groups_.regions[i].number,
                      nodes_.has_middles() ? gmsh_tetrahedron_10 : gmsh_tetrahedron, region.tets);
    end_ = tets_.open(region, end_, heading.all(), tet_bytes(nodes_));
  }
}

std::span<const Size> GmshWriter::numbered(Size number, std::span<const Size> nodes) {
  record_[0] = number;
  for (std::size_t i = 0; i < nodes.size(); ++i) record_[i + 1] = nodes[i] + 1;
  return {record_.data(), nodes.size() + 1};
}

void GmshWriter::put_tets(std::uint64_t first, std::span<const Tet<std::uint64_t>> tets,
                          std::span<const std::int32_t> labels) {
  for (std::size_t i = 0; i < tets.size(); ++i) {
    const std::span<const Size> record = numbered(first + i + 1, nodes_.tet(tets[i]));
    tets_.append(labels[i], std::as_bytes(record));
  }
}

void GmshWriter::close() {
  tets_.flush();
  Section out(file_, end_);
  Size number = size_.tets;
  for (const Sheet& sheet : groups_.sheets.all()) {
    const Int type = nodes_.has_middles() ? gmsh_triangle_6 : gmsh_triangle;
    out.append(block_heading(surface_dimension, sheet.number, type, sheet.faces).all());
    groups_.sheets.for_each_face(sheet, [&](const BoundaryFace& face) {
      out.append_all(numbered(++number, nodes_.face(face.points)));
    });
  }
  out.append_text(footer);
  out.flush();
  file_.write_at(0, header_of(groups_, box_).all());  // now that the box is known
}

}  // namespace

std::unique_ptr<MeshWriter> open_gmsh(const std::filesystem::path& file, const MeshSize& size) {
  return std::make_unique<GmshWriter>(file, size);
}

std::uint64_t gmsh_bytes(const MeshSize& size) {
  const Survey& survey = survey_of(size);
  const GmshGroups groups(survey);
  const ElementNodes nodes(size);
  const std::uint64_t faces = face_count(survey);
  const std::uint64_t blocks = groups.regions.size() + groups.sheets.all().size();
  return header_of(groups, {}).all().size() +
         nodes_heading(groups, size.points).all().size() +
         size.points * (sizeof(Size) + sizeof(Point3)) +
         elements_heading(groups, size.tets + faces).all().size() +
         blocks * block_heading(0, 0, 0, 0).all().size() + size.tets * tet_bytes(nodes) +
         faces * face_bytes(nodes) + footer.size();
}

}  // namespace certet::formats
