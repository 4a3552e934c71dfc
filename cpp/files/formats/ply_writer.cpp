// Binary PLY: the points of the boundary in double precision, and triangles.  They
// have no patches, for some programs stumble over properties that they do not know.

#include <bit>
#include <limits>

#include "registry.hpp"
#include "section.hpp"
#include "surface_writer.hpp"

namespace certet::formats {
namespace {

class PlyWriter final : public SurfaceWriter {
 public:
  PlyWriter(const std::filesystem::path& file, const MeshSize& size)
      : SurfaceWriter(file, size) {}

 private:
  void close() override {
    if (kept().size() > std::size_t{std::numeric_limits<std::int32_t>::max()})
      file_.fail("PLY numbers points with 32 bits only");
    Section out(file_, 0);
    out.append_text(heading());
    out.append_all(std::span<const Point3>(kept()));
    for (const BoundaryFace& face : survey().boundary) {
      std::array<std::int32_t, 3> points;
      for (std::size_t v = 0; v < 3; ++v)
        points[v] = static_cast<std::int32_t>(rank(face.points[v]));
      const std::uint8_t corners = 3;
      out.append_all(std::span(&corners, 1));
      out.append_all(std::span<const std::int32_t>(points));
    }
    out.flush();
  }

  [[nodiscard]] std::string heading() const {
    const bool little = std::endian::native == std::endian::little;
    return std::string("ply\nformat binary_") + (little ? "little" : "big") +
           "_endian 1.0\ncomment certet\n" +
           (size_.space.empty() ? "" : "comment SPACE=" + size_.space + "\n") + "element vertex " +
           std::to_string(kept().size()) +
           "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
           std::to_string(survey().boundary.size()) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
  }
};

}  // namespace

std::unique_ptr<MeshWriter> open_ply(const std::filesystem::path& file, const MeshSize& size) {
  return std::make_unique<PlyWriter>(file, size);
}

std::uint64_t ply_bytes(const MeshSize& size) {
  // A closed surface has about half as many points as triangles.
  const std::uint64_t faces = survey_of(size).boundary.size();
  return 200 + 13 * faces + faces / 2 * sizeof(Point3);
}

}  // namespace certet::formats
