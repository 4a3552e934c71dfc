#pragma once
/// \file
/// Some layers of a mesh, on their way to the file.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/buffer.hpp"
#include "certet/checksum.hpp"
#include "certet/middle_nodes.hpp"
#include "certet/write_mesh.hpp"
#include "mesh/boundary.hpp"
#include "mesh/region_parts.hpp"
#include "seconds.hpp"

namespace certet::pipeline {

/// All that slabs are made from.  The layers of a slab are made by several
/// threads; each makes its own with one.
struct Source {
  const Stuffing& stuffing;
  const Frame& frame;
  const MaterialRuns& known;  ///< of a survey, or empty
  bool label_pieces = false;  ///< whether the pieces of each label are counted
  std::span<const Coord3> moved = {};  ///< the points of the mesh, or none: its own
  Nanoseconds emitting{0}, measuring{0}, writing{0};

  /// The tetrahedra of layers up to `end` use points up to those of layer
  /// `points_end(end)`, exclusive.
  [[nodiscard]] std::int32_t points_end(std::int32_t end) const {
    return stuffing.points_end(end);
  }
};

/// Points of some layers, in steps and, where they are wanted, in the coordinates
/// of the file.
class PointSlab {
 public:
  PointSlab(std::uint64_t capacity, bool world)
      : steps_(capacity), world_(world ? capacity : 0) {}

  /// From now on, the points of layers from `begin` on.
  void open(const Source& source, std::int32_t begin) {
    first_ = source.stuffing.first_point(begin);
  }
  void make_layer(Source& source, std::int32_t layer);
  [[nodiscard]] bool has_world() const { return !world_.empty(); }

  /// The points of layers [begin, end).
  [[nodiscard]] std::span<const Coord3> steps(const Stuffing& stuffing, std::int32_t begin,
                                              std::int32_t end) const;
  [[nodiscard]] std::span<const Point3> world(const Stuffing& stuffing, std::int32_t begin,
                                              std::int32_t end) const;
  static constexpr std::uint64_t bytes_per_point = sizeof(Coord3) + sizeof(Point3);

 private:
  std::uint64_t first_ = 0;
  Buffer<Coord3> steps_;
  Buffer<Point3> world_;
};

/// The middle nodes whose edges have their lower ends in the layers of a slab, in the coordinates
/// of the file.
class MiddleSlab {
 public:
  MiddleSlab(const Source& source, const MiddleNodes& middles)
      : source_(source), middles_(middles) {}

  /// Those of layers [begin, end); `points` are those of these and of the layer behind them.
  std::span<const Point3> make(const PointSlab& points, std::int32_t begin, std::int32_t end,
                               Context& context);

 private:
  void make_layer(std::span<const Coord3> points, std::uint64_t first_point, std::int32_t layer);

  const Source& source_;
  const MiddleNodes& middles_;
  std::uint64_t first_ = 0;
  std::vector<Point3> world_;
};

/// What is found in a layer of tetrahedra.
struct Findings {
  Quality lattice, world;
  std::uint64_t coincident_points = 0;  ///< of those of the layer and the one behind it
  Checksum points, tets;
  core::RegionCounts regions;
  core::LayerParts parts;  ///< where the pieces of labels are counted
};

/// Tetrahedra of some layers, and their labels.
template <class Index>
class TetSlab {
 public:
  TetSlab(std::uint64_t capacity, bool labels) : tets_(capacity), labels_(labels ? capacity : 0) {}

  /// From now on, the tetrahedra of layers from `begin` on.
  void open(const Source& source, std::int32_t begin) {
    first_ = source.stuffing.first_tet(begin);
  }
  /// `points` are those of the layer and of the one behind it.
  Findings make_layer(Source& source, const PointSlab& points, std::int32_t layer);
  /// The layers [begin, end), which have been made.
  void write(Source& source, std::int32_t begin, std::int32_t end, MeshWriter& writer) const;

 private:
  class LayerMeasure;

  [[nodiscard]] std::span<const Tet<Index>> tets(const Stuffing& stuffing,
                                                std::int32_t layer) const {
    return {tets_.begin() + (stuffing.first_tet(layer) - first_),
            tets_.begin() + (stuffing.first_tet(layer + 1) - first_)};
  }
  void find_materials(const Source& source, std::int32_t layer,
                      std::span<Material> materials) const;
  /// Asks for materials while it measures, as both want the corners; puts labels in their
  /// place, and adds up what each region has.
  void measure_layer(const Source& source, std::span<const Coord3> points, std::int32_t layer,
                     Findings& found);

  std::uint64_t first_ = 0;
  Buffer<Tet<Index>> tets_;
  Buffer<std::int32_t> labels_;
};

}  // namespace certet::pipeline
