#include "slab.hpp"

#include "certet/context.hpp"
#include "engine/corners.hpp"
#include "engine/emit.hpp"
#include "engine/parallel.hpp"
#include "mesh/quality/cell_runs.hpp"
#include "mesh/quality/lattice_measurement.hpp"

namespace certet::pipeline {
void PointSlab::make_layer(Source& source, std::int32_t layer) {
  const Timer timer(source.emitting);
  const std::uint64_t begin = source.stuffing.first_point(layer) - first_;
  const std::uint64_t end = source.stuffing.first_point(layer + 1) - first_;
  const std::span<Coord3> own{steps_.begin() + begin, steps_.begin() + end};
  core::OneThread context;
  if (source.moved.empty())
    source.stuffing.emit_points(layer, layer + 1, own, context);
  else
    std::ranges::copy(source.moved.subspan(first_ + begin, own.size()), own.begin());
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

std::span<const Point3> MiddleSlab::make(const PointSlab& points, std::int32_t begin,
                                         std::int32_t end, Context& context) {
  const Stuffing& stuffing = source_.stuffing;
  const std::uint64_t first_point = stuffing.first_point(begin);
  first_ = middles_.first(first_point);
  world_.resize(static_cast<std::size_t>(middles_.first(stuffing.first_point(end)) - first_));
  const std::span<const Coord3> steps =
      points.steps(stuffing, begin, source_.points_end(end));
  core::parallel_for(context, Stage::emit, end - begin, [&](std::int64_t task) {
    make_layer(steps, first_point, begin + static_cast<std::int32_t>(task));
  });
  return world_;
}

void MiddleSlab::make_layer(std::span<const Coord3> points, std::uint64_t first_point,
                            std::int32_t layer) {
  const std::uint64_t from = source_.stuffing.first_point(layer);
  const std::uint64_t to = source_.stuffing.first_point(layer + 1);
  auto bend = std::ranges::lower_bound(middles_.bends(), middles_.first(from), {}, &Bend::node);
  middles_.for_each(from, to, [&](std::uint64_t node, std::uint64_t a, std::uint64_t b) {
    const bool bent = bend != middles_.bends().end() && bend->node == node;
    world_[node - first_] =
        middle_in_world(source_.frame, points[a - first_point], points[b - first_point],
                        bent ? (bend++)->by : Coord3{0, 0, 0});
  });
}

/// Those that are known before the corners are.
template <class Index>
void TetSlab<Index>::find_materials(const Source& source, std::int32_t layer,
                                    std::span<Material> materials) const {
  core::OneThread context;
  if (!source.known.empty()) source.known.get(layer, materials);
  else if (source.stuffing.has_interfaces())
    source.stuffing.emit_materials(layer, layer + 1, materials, context);
}

/// Measures the tetrahedra of a layer and adds up what each region has.
template <class Index>
class TetSlab<Index>::LayerMeasure {
 public:
  LayerMeasure(const Source& source, std::span<const Coord3> points, std::int32_t layer,
               std::span<const Tet<Index>> tets, std::span<std::int32_t> labels, Findings& found)
      : source_(source), points_(points), first_point_(source.stuffing.first_point(layer)),
        tets_(tets), labels_(labels), lattice_(points), found_(found),
        asks_(!labels.empty() && source.known.empty() && !source.stuffing.has_interfaces()) {}

  void run() {
    core::CellRuns<Index>(points_, first_point_, tets_)
        .for_each([&](std::size_t begin, std::size_t cells) { add_cells(begin, cells); },
                  [&](std::size_t begin, std::size_t count) { add_tets(begin, count); });
    if (labels_.empty() && !tets_.empty()) found_.regions.add(only_label, tets_.size());
    found_.lattice = lattice_.result();
  }

 private:
  /// A run of cells: of the first each tetrahedron is measured, and counted for all.
  void add_cells(std::size_t begin, std::size_t cells) {
    for_each_batch(begin, core::cell_tet_count, [&](std::size_t, std::span<const TetCorners> corners) {
      lattice_.add_copies(corners, cells, std::span(six_volumes_).first(corners.size()));
    });
    if (labels_.empty()) return;
    const std::size_t count = cells * core::cell_tet_count;
    if (asks_)
      for_each_batch(begin, count, [&](std::size_t from, std::span<const TetCorners> corners) {
        source_.stuffing.materials_of(corners, labels_.subspan(from, corners.size()));
      });
    add_regions(begin, count, core::cell_tet_count);
  }

  void add_tets(std::size_t begin, std::size_t count) {
    for_each_batch(begin, count, [&](std::size_t from, std::span<const TetCorners> corners) {
      lattice_.add(corners, std::span(six_volumes_).first(corners.size()));
      if (labels_.empty()) return;
      if (asks_) source_.stuffing.materials_of(corners, labels_.subspan(from, corners.size()));
      add_regions(from, corners.size(), corners.size());
    });
  }

  /// Puts labels in their place; volumes repeat after `period` tetrahedra.
  void add_regions(std::size_t begin, std::size_t count, std::size_t period) {
    std::size_t at = 0;
    core::labels_in_place(labels_.subspan(begin, count), source_.stuffing.labels(),
                          [&](std::int32_t label, std::uint64_t run) {
                            found_.regions.add(label, run, six_volumes(at, run, period));
                            at += run;
                          });
  }

  [[nodiscard]] WideSum six_volumes(std::size_t from, std::uint64_t count,
                                    std::size_t period) const {
    WideSum sum;
    if (const std::uint64_t times = count / period; times > 1)
      for (std::size_t n = 0; n < period; ++n) sum += WideSum::product(six_volumes_[n], times);
    const std::uint64_t summed = count / period > 1 ? count / period * period : 0;
    for (std::uint64_t n = summed; n < count; ++n) sum += six_volumes_[(from + n) % period];
    return sum;
  }

  template <class Visit>
  void for_each_batch(std::size_t begin, std::size_t count, const Visit& visit) const {
    core::for_each_batch(points_, first_point_, tets_.subspan(begin, count),
                         [&](std::size_t from, std::span<const TetCorners> corners) {
                           visit(begin + from, corners);
                         });
  }

  const Source& source_;
  std::span<const Coord3> points_;
  std::uint64_t first_point_;
  std::span<const Tet<Index>> tets_;
  std::span<std::int32_t> labels_;
  core::LatticeMeasurement lattice_;
  std::array<std::int64_t, core::batch_size> six_volumes_{};
  Findings& found_;
  bool asks_;  ///< the domain, for materials
};

template <class Index>
void TetSlab<Index>::measure_layer(const Source& source, std::span<const Coord3> points,
                                   std::int32_t layer, Findings& found) {
  const std::span<const Tet<Index>> made = tets(source.stuffing, layer);
  const std::span<std::int32_t> labels{
      labels_.begin() + (labels_.empty() ? 0 : source.stuffing.first_tet(layer) - first_),
      labels_.empty() ? 0 : made.size()};
  if (!labels.empty()) find_materials(source, layer, labels);
  LayerMeasure(source, points, layer, made, labels, found).run();
}

template <class Index>
Findings TetSlab<Index>::make_layer(Source& source, const PointSlab& points, std::int32_t layer) {
  const Stuffing& stuffing = source.stuffing;
  const std::uint64_t first_tet = stuffing.first_tet(layer);
  const std::span<const Tet<Index>> made = tets(stuffing, layer);
  {
    const Timer timer(source.emitting);
    core::OneThread context;
    stuffing.emit_tets(layer, layer + 1, {tets_.begin() + (first_tet - first_), made.size()},
                       context);
  }
  const Timer timer(source.measuring);
  const std::int32_t behind = source.points_end(layer + 1);
  const std::uint64_t first_point = stuffing.first_point(layer);
  Findings found;
  measure_layer(source, points.steps(stuffing, layer, behind), layer, found);
  if (points.has_world()) {
    const std::span<const Point3> world = points.world(stuffing, layer, behind);
    found.world = measure_world(world, first_point, made, Histogram::empty);
    found.coincident_points = count_coincident(world);
  }
  found.tets.tets(first_tet, made);
  found.points.points(first_point, points.steps(stuffing, layer, layer + 1));
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
