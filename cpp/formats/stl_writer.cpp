// Binary STL: triangles in single precision, each with its own three points.

#include <bit>
#include <cmath>
#include <limits>

#include "registry.hpp"
#include "section.hpp"
#include "surface_writer.hpp"

namespace certet::formats {
namespace {

static_assert(std::endian::native == std::endian::little, "the format's order of bytes");

using Single3 = std::array<float, 3>;

Single3 single(const Point3& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

/// Of length 1, or zero where a triangle has no area.
Single3 normal(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const Point3 v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  const Point3 n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                 u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0};
  return single({n[0] / length, n[1] / length, n[2] / length});
}

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
    std::ranges::copy(std::string_view("certet"), heading.begin());
    out.append_all(std::span<const char>(heading));
    const auto count = static_cast<std::uint32_t>(survey().boundary.size());
    out.append_all(std::span(&count, 1));
    for (const BoundaryFace& face : survey().boundary) {
      const auto [a, b, c] = face.points;
      const Point3 &p = kept()[rank(a)], &q = kept()[rank(b)], &r = kept()[rank(c)];
      const std::array<Single3, 4> triangle{normal(p, q, r), single(p), single(q), single(r)};
      const std::uint16_t attribute = 0;
      out.append_all(std::span<const Single3>(triangle));
      out.append_all(std::span(&attribute, 1));
    }
    out.flush();
  }
};

}  // namespace

std::unique_ptr<MeshWriter> open_stl(const std::filesystem::path& file, const MeshSize& size) {
  return std::make_unique<StlWriter>(file, size);
}

std::uint64_t stl_bytes(const MeshSize& size) {
  return 84 + 50 * (size.survey == nullptr ? 0 : size.survey->boundary.size());
}

}  // namespace certet::formats
