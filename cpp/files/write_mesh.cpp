#include "certet/write_mesh.hpp"

#include <array>
#include <limits>
#include <new>
#include <utility>
#include <vector>

#include "certet/checksum.hpp"
#include "certet/error.hpp"
#include "engine/parallel.hpp"
#include "gathered.hpp"
#include "slab.hpp"

namespace certet {
namespace {

using pipeline::Findings;
using pipeline::MiddleSlab;
using pipeline::PointSlab;
using pipeline::Source;
using pipeline::TetSlab;
using pipeline::Timer;

bool fits_32_bits(const Stuffing& stuffing) {
  return stuffing.point_count() <= std::numeric_limits<std::uint32_t>::max();
}

/// What is held to write slabs of so many points and tetrahedra: tetrahedra
/// twice, as one slab is written while the next is made; points in both passes.
std::uint64_t held_bytes(const Stuffing& stuffing, std::uint64_t points, std::uint64_t tets) {
  const std::uint64_t tet = (fits_32_bits(stuffing) ? sizeof(Tet<std::uint32_t>)
                                                    : sizeof(Tet<std::uint64_t>)) +
                            sizeof(std::int32_t);
  return 2 * (tet * tets + PointSlab::bytes_per_point * points);
}

/// The layers of slab s.
struct Layers {
  std::int32_t begin, end;
};

Layers layers_of(const Slabs& slabs, std::size_t s) {
  return {slabs.bounds[s], slabs.bounds[s + 1]};
}

/// Runs write_before() and make(layer) for the layers [begin, end), side by side.
template <class WriteBefore, class Make>
void write_and_make(Layers layers, Context& context, const WriteBefore& write_before,
                    const Make& make) {
  core::parallel_for(context, Stage::emit, 1 + layers.end - layers.begin, [&](std::int64_t task) {
    if (task == 0)
      write_before();
    else
      make(layers.begin + static_cast<std::int32_t>(task) - 1);
  });
}

/// \returns the checksum of the points as the file has them.
Checksum write_points(Source& source, const Slabs& slabs, std::array<PointSlab, 2>& store,
                      MeshWriter& writer, Context& context) {
  const Stuffing& stuffing = source.stuffing;
  std::vector<Checksum> layers(static_cast<std::size_t>(stuffing.layers()));
  const auto write = [&](std::size_t s) {
    const Timer timer(source.writing);
    const auto [begin, end] = layers_of(slabs, s);
    writer.points(store[s % 2].world(stuffing, begin, end));
  };
  const std::size_t count = slabs.bounds.size() - 1;
  for (std::size_t s = 0; s < count; ++s) {
    PointSlab& slab = store[s % 2];
    slab.open(source, slabs.bounds[s]);
    write_and_make(
        layers_of(slabs, s), context, [&] { if (s > 0) write(s - 1); },
        [&](std::int32_t layer) {
          slab.make_layer(source, layer);
          layers[static_cast<std::size_t>(layer)].points(stuffing.first_point(layer),
                                                         slab.world(stuffing, layer, layer + 1));
        });
  }
  write(count - 1);
  Checksum checksum;
  for (const Checksum& layer : layers) checksum += layer;
  return checksum;
}

/// Behind the corners.
void write_middle_points(Source& source, const Slabs& slabs, const MiddleNodes& middles,
                         MeshWriter& writer, Context& context) {
  PointSlab points(slabs.points, false);
  MiddleSlab slab(source, middles);
  for (std::size_t s = 0; s + 1 < slabs.bounds.size(); ++s) {
    const auto [begin, end] = layers_of(slabs, s);
    points.open(source, begin);
    core::parallel_for(context, Stage::emit, source.points_end(end) - begin,
                       [&, first = begin](std::int64_t i) {
                         points.make_layer(source, first + static_cast<std::int32_t>(i));
                       });
    const std::span<const Point3> made = slab.make(points, begin, end, context);
    const Timer timer(source.writing);
    writer.points(made);
  }
}

/// Glues the layers of one slab after the other.
class SlabParts {
 public:
  explicit SlabParts(const Stuffing& stuffing) : stuffing_(stuffing) {}

  void add(std::int32_t begin, std::vector<Findings>& found, Context& context) {
    const auto layer_before = [&](std::size_t n) -> const core::LayerParts& {
      return n == 0 ? last_ : found[n - 1].parts;
    };
    std::vector<core::JoinedParts> joined(found.size());
    core::parallel_for(context, Stage::emit, static_cast<std::int64_t>(found.size()),
                       [&](std::int64_t task) {
                         const auto n = static_cast<std::size_t>(task);
                         const std::int32_t layer = begin + static_cast<std::int32_t>(task);
                         if (layer > 0)
                           joined[n] = core::find_joined_parts(stuffing_, layer - 1,
                                                               layer_before(n), found[n].parts);
                       });
    for (std::size_t n = 0; n < found.size(); ++n) parts_.add(found[n].parts, joined[n]);
    last_ = std::move(found.back().parts);
  }

  [[nodiscard]] std::vector<RegionPieces> pieces() { return parts_.pieces(); }

 private:
  const Stuffing& stuffing_;
  core::RegionParts parts_;
  core::LayerParts last_;  ///< of the layer that was added last
};

template <class Index>
void write_tets(Source& source, const Slabs& slabs, PointSlab& points, Checksum placed,
                MeshWriter& writer, Context& context, WrittenMesh& written) {
  const bool labels = !source.stuffing.labels().empty();
  std::array<TetSlab<Index>, 2> store{TetSlab<Index>(slabs.tets, labels),
                                      TetSlab<Index>(slabs.tets, labels)};
  Checksum checksum, tets;
  core::RegionCounts regions;
  SlabParts parts(source.stuffing);
  const auto write = [&](std::size_t s) {
    const auto [begin, end] = layers_of(slabs, s);
    store[s % 2].write(source, begin, end, writer);
  };
  const std::size_t count = slabs.bounds.size() - 1;
  for (std::size_t s = 0; s < count; ++s) {
    const auto [begin, end] = layers_of(slabs, s);
    points.open(source, begin);
    core::parallel_for(context, Stage::emit, source.points_end(end) - begin,
                       [&, first = begin](std::int64_t i) {
                         points.make_layer(source, first + static_cast<std::int32_t>(i));
                       });
    TetSlab<Index>& slab = store[s % 2];
    slab.open(source, begin);
    std::vector<Findings> found(static_cast<std::size_t>(end - begin));
    write_and_make(
        {begin, end}, context, [&] { if (s > 0) write(s - 1); },
        [&, first = begin](std::int32_t layer) {
          found[static_cast<std::size_t>(layer - first)] = slab.make_layer(source, points, layer);
        });
    // In the order of layers, so that sums of rounded numbers are always the same.
    for (const Findings& layer : found) {
      written.lattice += layer.lattice;
      written.world += layer.world;
      written.coincident_points += layer.coincident_points;
      checksum += layer.points;
      tets += layer.tets;
      regions += layer.regions;
    }
    if (source.label_pieces) parts.add(begin, found, context);
  }
  write(count - 1);
  written.checksum = (checksum += tets).value();
  written.file_checksum = (placed += tets).value();
  if (Ranks* ranks = source.stuffing.ranks()) {
    pipeline::gather(*ranks, written);
    pipeline::gather(*ranks, regions);
  }
  written.regions = regions.regions();
  written.region_pieces = parts.pieces();
}

/// The greatest magnitude of a coordinate of the lattice, in lattice units.
std::int32_t reach(const Lattice& lattice) {
  const Coord3 low = lattice.origin;
  const Coord3 high = low + 2 * Coord3{lattice.cells[0], lattice.cells[1], lattice.cells[2]};
  return std::max({-low.x, -low.y, -low.z, high.x, high.y, high.z});
}

Checksum write_points(Source& source, const Slabs& slabs, MeshWriter& writer,
                      Context& context) {
  std::array<PointSlab, 2> points{PointSlab(slabs.points, true), PointSlab(slabs.points, true)};
  return write_points(source, slabs, points, writer, context);
}

WrittenMesh write_all(Source& source, const Slabs& slabs, const MiddleNodes* middles,
                      MeshWriter& writer, Context& context) {
  WrittenMesh written;
  const Checksum placed = write_points(source, slabs, writer, context);
  if (middles != nullptr) write_middle_points(source, slabs, *middles, writer, context);
  const std::int32_t farthest = reach(source.stuffing.lattice());
  const bool rounds = rounding_matters(source.frame, farthest);
  PointSlab points(slabs.points, rounds);
  if (fits_32_bits(source.stuffing))
    write_tets<std::uint32_t>(source, slabs, points, placed, writer, context, written);
  else
    write_tets<std::uint64_t>(source, slabs, points, placed, writer, context, written);
  if (!rounds) written.world = similar(written.lattice, source.frame);
  written.rounding = angle_rounding(source.frame, farthest, written.lattice);
  written.emit_seconds = pipeline::seconds(source.emitting);
  written.measure_seconds = pipeline::seconds(source.measuring);
  written.write_seconds = pipeline::seconds(source.writing);
  stop_if_cancelled(context);
  return written;
}

}  // namespace

Slabs cut_slabs(const Stuffing& stuffing, std::uint64_t max_bytes) {
  Slabs slabs;
  slabs.bounds.push_back(stuffing.own_begin());
  for (std::int32_t layer = stuffing.own_begin(); layer < stuffing.own_end(); ++layer) {
    const std::int32_t behind = stuffing.points_end(layer + 1);
    const auto points_from = [&](std::int32_t begin) {
      return std::max(slabs.points, stuffing.first_point(behind) - stuffing.first_point(begin));
    };
    const auto tets_from = [&](std::int32_t begin) {
      return std::max(slabs.tets, stuffing.first_tet(layer + 1) - stuffing.first_tet(begin));
    };
    const std::int32_t begin = slabs.bounds.back();
    if (layer > begin && held_bytes(stuffing, points_from(begin), tets_from(begin)) > max_bytes)
      slabs.bounds.push_back(layer);
    slabs.points = points_from(slabs.bounds.back());
    slabs.tets = tets_from(slabs.bounds.back());
  }
  slabs.bounds.push_back(stuffing.own_end());
  slabs.bytes = held_bytes(stuffing, slabs.points, slabs.tets);
  return slabs;
}

WrittenMesh write_mesh(const Stuffing& stuffing, const Frame& frame, const Slabs& slabs,
                       MeshWriter& writer, Context& context, const MaterialRuns& known,
                       bool label_pieces, const MiddleNodes* middles,
                       std::span<const Coord3> moved) {
  checked_size(frame.size);
  try {
    Source source{stuffing, frame, known, label_pieces && stuffing.labels().size() > 1 && !stuffing.has_interfaces()};
    source.moved = moved;
    return write_all(source, slabs, middles, writer, context);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "out of memory while writing the mesh");
  }
}

}  // namespace certet
