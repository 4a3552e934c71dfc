#pragma once
/// \file
/// Holding a writer's caller to what was announced.

#include <algorithm>
#include <cstdint>
#include <span>

#include "certet/formats.hpp"
#include "output_file.hpp"

namespace certet::formats {

/// Counts what is written.  Members throw Error `write_failed` if it is more or
/// less than announced, in the wrong order, or names points that are not there.
class Announced {
 public:
  Announced(const MeshSize& size, const WritableFile& file)
      : Announced(size, {0, size.points, 0, size.tets, true}, file) {}
  /// Of a part of the mesh, the tetrahedra of which may name points of other parts.
  Announced(const MeshSize& size, const MeshPart& part, const WritableFile& file)
      : size_(size), part_(part), file_(file) {}

  void points(std::uint64_t count);
  template <class Index>
  void tets(std::span<const Tet<Index>> tets, std::span<const std::int32_t> labels) {
    count_tets(tets.size(), labels.size());
    Index greatest = 0;
    for (const Tet<Index>& tet : tets)
      for (const Index index : tet) greatest = std::max(greatest, index);
    if (!tets.empty() && greatest >= size_.points)
      file_.fail("a tetrahedron names a point that is not there");
  }
  void finish() const;

 private:
  void count_tets(std::uint64_t count, std::uint64_t labels);

  MeshSize size_;
  MeshPart part_;
  const WritableFile& file_;
  std::uint64_t points_ = 0, tets_ = 0;
};

}  // namespace certet::formats
