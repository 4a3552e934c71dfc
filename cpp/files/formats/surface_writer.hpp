#pragma once
/// \file
/// What the formats for surfaces alone have in common.

#include <vector>

#include "streamed_writer.hpp"

namespace certet::formats {

/// Keeps the points of the boundary, and of the interfaces where they are wanted, numbered
/// anew in their old order.
class SurfaceWriter : public StreamedWriter {
 protected:
  SurfaceWriter(const std::filesystem::path& file, const MeshSize& size, bool interfaces = false);

  /// Those that the faces have.
  [[nodiscard]] const std::vector<Point3>& kept() const { return kept_; }
  /// The number of a point among those.
  [[nodiscard]] std::size_t rank(std::uint64_t point) const;

 private:
  void put_points(std::uint64_t first, std::span<const Point3> points) final;
  void put_tets(std::uint64_t, std::span<const Tet<std::uint64_t>>,
                std::span<const std::int32_t>) final {}

  std::vector<std::uint64_t> numbers_;  ///< of the points to keep, growing
  std::vector<Point3> kept_;
};

}  // namespace certet::formats
