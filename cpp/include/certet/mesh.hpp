#pragma once
/// \file
/// The output of the engine.

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

#include "certet/border.hpp"
#include "certet/buffer.hpp"
#include "certet/frame.hpp"
#include "certet/labels.hpp"
#include "certet/method.hpp"
#include "certet/patch.hpp"

namespace certet {

/// Four numbers of points, in an order that gives a positive volume:
/// det(p1-p0, p2-p0, p3-p0) > 0.
template <class Index>
using Tet = std::array<Index, 4>;

/// Tetrahedra with 32-bit indices, or with 64-bit ones where the number of
/// points asks for it.
using Tets = std::variant<Buffer<Tet<std::uint32_t>>, Buffer<Tet<std::uint64_t>>>;

/// A tetrahedral mesh in exact lattice coordinates, and the way to the world.
struct Mesh {
  Buffer<Coord3> points;  ///< positions in steps
  Tets tets;
  Frame frame;
  Buffer<std::int32_t> labels = {};  ///< of the tetrahedra; empty where the domain has none
  LabelNames names = {};             ///< of labels, where the domain knew some
  std::vector<BorderBox> border = {};  ///< at whose faces the shape is cut off
  Method method{};                   ///< that it was made by in the end; its theorem covers it
  std::vector<PatchChoice> patches = {};  ///< of its boundary, beside those that it has

  [[nodiscard]] std::size_t tet_count() const {
    return std::visit([](const auto& t) { return t.size(); }, tets);
  }
};

/// The points of a mesh in world coordinates, in the units of its domain.
/// \throws Error `too_large` (out of memory).
Buffer<Point3> world_points(const Mesh& mesh);

}  // namespace certet
