// Binary STL: triangles in single precision, each with its own three points.

#include <bit>
#include <limits>

#include "registry.hpp"
#include "section.hpp"
#include "single_precision.hpp"
#include "surface_writer.hpp"

namespace certet::formats {
namespace {

static_assert(std::endian::native == std::endian::little, "the format's order of bytes");

class StlWriter final : public SurfaceWriter {
 public:
  StlWriter(const std::filesystem::path& file, const MeshSize& size)
      : SurfaceWriter(file, size) {
    if (survey().boundary.size() > std::numeric_limits<std::uint32_t>::max())
      file_.fail("STL counts triangles with 32 bits only");
    file_.reserve(stl_bytes(size));
  }

 private:
  void close() override {
    Section out(file_, 0);
    std::array<char, 80> heading{};
    const std::string text = "certet" + (size_.space.empty() ? "" : " SPACE=" + size_.space);
    std::ranges::copy_n(text.begin(), static_cast<std::ptrdiff_t>(std::min(text.size(), heading.size())),
                        heading.begin());
    out.append_all(std::span<const char>(heading));
    const auto count = static_cast<std::uint32_t>(survey().boundary.size());
    out.append_all(std::span(&count, 1));
    SinglePrecisionCheck check;
    check.add(kept());
    for (const BoundaryFace& face : survey().boundary) {
      const auto [a, b, c] = face.points;
      const Triangle3 triangle{kept()[rank(a)], kept()[rank(b)], kept()[rank(c)]};
      const auto& [p, q, r] = triangle;
      check.add(triangle);
      const std::array<Single3, 4> record{single(normal_of(triangle)), single(p), single(q),
                                          single(r)};
      const std::uint16_t attribute = 0;
      out.append_all(std::span<const Single3>(record));
      out.append_all(std::span(&attribute, 1));
    }
    out.flush();
    if (const std::string loss = check.loss(); !loss.empty())
      file_.fail("single precision, which STL has, cannot hold the surface: " + loss +
                 "; .ply holds it, and --origin 0 brings it near 0");
  }
};

}  // namespace

std::unique_ptr<MeshWriter> open_stl(const std::filesystem::path& file, const MeshSize& size) {
  return std::make_unique<StlWriter>(file, size);
}

std::uint64_t stl_bytes(const MeshSize& size) {
  return 84 + 50 * survey_of(size).boundary.size();
}

}  // namespace certet::formats
