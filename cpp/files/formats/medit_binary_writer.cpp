#include <limits>

#include "element_nodes.hpp"
#include "medit_binary.hpp"
#include "registry.hpp"
#include "section.hpp"
#include "sheets.hpp"
#include "streamed_writer.hpp"

namespace certet::formats {
namespace {

using namespace medit_binary;

/// The widths of numbers, and where every block begins.
struct Layout {
  explicit Layout(const MeshSize& size) {
    const std::uint64_t faces = face_count(survey_of(size));
    constexpr std::uint64_t limit = std::numeric_limits<std::int32_t>::max();
    const bool many = std::max({size.points, size.tets, faces}) > limit;
    version = many ? 4 : 2;
    lay_out(size, faces);
    // Beyond 2 GiB, places do not fit in 32 bits.
    if (version == 2 && bytes > limit) {
      version = 3;
      lay_out(size, faces);
    }
  }

  [[nodiscard]] bool wide_places() const { return version >= 3; }
  [[nodiscard]] bool wide_indices() const { return version >= 4; }

  std::int32_t version;
  std::uint64_t vertices_at, tets_at, faces_at, end_at, bytes;

 private:
  void lay_out(const MeshSize& size, std::uint64_t faces) {
    const std::uint64_t place = wide_places() ? 8 : 4;
    const std::uint64_t index = wide_indices() ? 8 : 4;
    const std::uint64_t head = 4 + place + place;  // keyword, next place, count
    vertices_at = 8 + (4 + place + 4);             // the dimension is always of 32 bits
    tets_at = vertices_at + head + size.points * (24 + index);
    const ElementNodes nodes(size);
    faces_at = tets_at + head + size.tets * (nodes.per_tet() + 1) * index;
    end_at = faces_at + head + faces * (nodes.per_face() + 1) * index;
    bytes = end_at + 4 + place;
  }
};

class MeditBinaryWriter final : public StreamedWriter {
 public:
  MeditBinaryWriter(const std::filesystem::path& file, const MeshSize& size)
      : StreamedWriter(file, size), layout_(size), nodes_(size), out_(file_, 0) {
    file_.reserve(layout_.bytes);
    put(mark);
    put(layout_.version);
    put(std::int32_t{dimension});
    put_place(layout_.vertices_at);
    put(std::int32_t{3});
    open(vertices, layout_.tets_at, size.points);
  }

 private:
  template <class Number>
  void put(Number number) {
    out_.append_all(std::span<const Number>(&number, 1));
  }
  void put_place(std::uint64_t place) { put_number(place, layout_.wide_places()); }
  void put_index(std::int64_t index) {
    put_number(static_cast<std::uint64_t>(index), layout_.wide_indices());
  }
  void put_number(std::uint64_t number, bool wide) {
    if (wide)
      put(static_cast<std::int64_t>(number));
    else
      put(static_cast<std::int32_t>(number));
  }
  void open(Keyword keyword, std::uint64_t next, std::uint64_t count) {
    put(std::int32_t{keyword});
    put_place(next);
    put_place(count);
  }

  void put_element(std::span<const std::uint64_t> points, std::int32_t reference) {
    for (const std::uint64_t point : points) put_index(static_cast<std::int64_t>(point + 1));
    put_index(reference);
  }

  void put_points(std::uint64_t, std::span<const Point3> points) override {
    for (const Point3& point : points) {
      put(point);
      put_index(0);
    }
  }
  void open_tets() override {
    open(nodes_.has_middles() ? tetrahedra_p2 : tetrahedra, layout_.faces_at, size_.tets);
  }
  void put_tets(std::uint64_t, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override {
    for (std::size_t i = 0; i < tets.size(); ++i) put_element(nodes_.tet(tets[i]), labels[i]);
  }
  void close() override {
    open(nodes_.has_middles() ? triangles_p2 : triangles, layout_.end_at,
         face_count(survey()));
    Sheets::for_each_face(survey(), [&](const BoundaryFace& face, std::int32_t number) {
      put_element(nodes_.face(face.points), number);
    });
    put(std::int32_t{end});
    put_place(0);
    out_.flush();
  }

  Layout layout_;
  ElementNodes nodes_;
  Section out_;
};

}  // namespace

std::unique_ptr<MeshWriter> open_medit_binary(const std::filesystem::path& file,
                                              const MeshSize& size) {
  return std::make_unique<MeditBinaryWriter>(file, size);
}

std::uint64_t medit_binary_bytes(const MeshSize& size) { return Layout(size).bytes; }

}  // namespace certet::formats
