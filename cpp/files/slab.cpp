#include "slab.hpp"

#include "certet/context.hpp"
#include "certet/lattice/orientation.hpp"
#include "engine/corners.hpp"
#include "engine/emit.hpp"
#include "mesh/quality/lattice_measurement.hpp"

namespace certet::pipeline {
namespace {

/// For what the engine does within a single layer.
struct OneThread : Context {
  OneThread() { threads = 1; }
};

}  // namespace

void PointSlab::make_layer(Source& source, std::int32_t layer) {
  const Timer timer(source.emitting);
  const std::uint64_t begin = source.stuffing.first_point(layer) - first_;
  const std::uint64_t end = source.stuffing.first_point(layer + 1) - first_;
  OneThread context;
  source.stuffing.emit_points(layer, layer + 1, {steps_.begin() + begin, steps_.begin() + end},
                              context);
  if (!has_world()) return;
  for (std::uint64_t i = begin; i < end; ++i) world_[i] = source.frame.world(steps_[i]);
}

std::span<const Coord3> PointSlab::steps(const Stuffing& stuffing, std::int32_t begin,
                                         std::int32_t end) const {
  return {steps_.begin() + (stuffing.first_point(begin) - first_),
          steps_.begin() + (stuffing.first_point(end) - first_)};
}

std::span<const Point3> PointSlab::world(const Stuffing& stuffing, std::int32_t begin,
                                         std::int32_t end) const {
  return {world_.begin() + (stuffing.first_point(begin) - first_),
          world_.begin() + (stuffing.first_point(end) - first_)};
}

/// Asks for materials while it measures, as both want the corners.
template <class Index>
Quality TetSlab<Index>::measure_layer(const Source& source, std::span<const Coord3> points,
                                      std::int32_t layer) {
  const Stuffing& stuffing = source.stuffing;
  const std::uint64_t begin = stuffing.first_tet(layer) - first_;
  const bool asks = !labels_.empty() && source.known.empty() && !stuffing.has_interfaces();
  core::LatticeMeasurement lattice(points);
  core::for_each_batch(points, stuffing.first_point(layer), tets(stuffing, layer),
                       [&](std::size_t from, std::span<const TetCorners> corners) {
                         lattice.add(corners);
                         if (asks)
                           stuffing.materials_of(corners, {labels_.begin() + begin + from,
                                                           corners.size()});
                       });
  return lattice.result();
}

template <class Index>
core::RegionCounts TetSlab<Index>::label_layer(const Source& source,
                                               std::span<const Coord3> points,
                                               std::int32_t layer) {
  const Stuffing& stuffing = source.stuffing;
  const std::span<const Tet<Index>> made = tets(stuffing, layer);
  const std::size_t count = made.size();
  core::RegionCounts regions;
  if (labels_.empty()) {
    if (count != 0) regions.add(only_label, count);
    return regions;
  }
  const std::span<std::int32_t> labels{
      labels_.begin() + (stuffing.first_tet(layer) - first_), count};
  if (!source.known.empty()) {
    source.known.get(layer, labels);
  } else if (stuffing.has_interfaces()) {
    OneThread context;
    stuffing.emit_materials(layer, layer + 1, labels, context);
  }
  const std::uint64_t first_point = stuffing.first_point(layer);
  std::size_t begin = 0;
  core::labels_in_place(labels, stuffing.labels(), [&](std::int32_t label, std::uint64_t run) {
    WideSum six_volumes;
    for (const Tet<Index>& tet : made.subspan(begin, run))
      six_volumes += six_volume(points[tet[0] - first_point], points[tet[1] - first_point],
                                points[tet[2] - first_point], points[tet[3] - first_point]);
    regions.add(label, run, six_volumes);
    begin += run;
  });
  return regions;
}

template <class Index>
Findings TetSlab<Index>::make_layer(Source& source, const PointSlab& points, std::int32_t layer) {
  const Stuffing& stuffing = source.stuffing;
  const std::uint64_t first_tet = stuffing.first_tet(layer);
  const std::span<const Tet<Index>> made = tets(stuffing, layer);
  {
    const Timer timer(source.emitting);
    OneThread context;
    stuffing.emit_tets(layer, layer + 1, {tets_.begin() + (first_tet - first_), made.size()},
                       context);
  }
  const Timer timer(source.measuring);
  const std::int32_t behind = source.points_end(layer + 1);
  const std::uint64_t first_point = stuffing.first_point(layer);
  Findings found;
  found.lattice = measure_layer(source, points.steps(stuffing, layer, behind), layer);
  if (points.has_world()) {
    const std::span<const Point3> world = points.world(stuffing, layer, behind);
    found.world = measure_world(world, first_point, made, Histogram::empty);
    found.coincident_points = count_coincident(world);
  }
  found.tets.tets(first_tet, made);
  found.points.points(first_point, points.steps(stuffing, layer, layer + 1));
  found.regions = label_layer(source, points.steps(stuffing, layer, behind), layer);
  if (source.label_pieces)
    found.parts = core::find_layer_parts(
        stuffing, layer, made,
        std::span<const std::int32_t>(labels_.begin() + (first_tet - first_), made.size()));
  return found;
}

template <class Index>
void TetSlab<Index>::write(Source& source, std::int32_t begin, std::int32_t end,
                           MeshWriter& writer) const {
  const Timer timer(source.writing);
  const std::uint64_t from = source.stuffing.first_tet(begin) - first_;
  const std::uint64_t to = source.stuffing.first_tet(end) - first_;
  const std::span<const Tet<Index>> tets{tets_.begin() + from, tets_.begin() + to};
  if (labels_.empty())
    writer.tets(tets, {});
  else
    writer.tets(tets, {labels_.begin() + from, labels_.begin() + to});
}

template class TetSlab<std::uint32_t>;
template class TetSlab<std::uint64_t>;

}  // namespace certet::pipeline
