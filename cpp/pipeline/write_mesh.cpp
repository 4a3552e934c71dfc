#include "certet/write_mesh.hpp"

#include <chrono>
#include <limits>
#include <new>
#include <utility>

#include "certet/checksum.hpp"
#include "certet/error.hpp"
#include "for_layers.hpp"

namespace certet {
namespace {

/// Adds the time of its life to a number of seconds.
class Timer {
 public:
  explicit Timer(double& seconds) : seconds_(seconds) {}
  ~Timer() {
    seconds_ += std::chrono::duration<double>(clock::now() - start_).count();
  }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

 private:
  using clock = std::chrono::steady_clock;
  double& seconds_;
  clock::time_point start_ = clock::now();
};

bool fits_32_bits(const Stuffing& stuffing) {
  return stuffing.point_count() <= std::numeric_limits<std::uint32_t>::max();
}

/// What the tetrahedra of a slab need besides their own points: those of the
/// layer behind.
std::int32_t points_end(const Stuffing& stuffing, std::int32_t end) {
  return std::min(end + 1, stuffing.layers());
}

std::uint64_t slab_bytes(const Stuffing& stuffing, std::int32_t begin, std::int32_t end) {
  const std::uint64_t tet = (fits_32_bits(stuffing) ? sizeof(Tet<std::uint32_t>)
                                                    : sizeof(Tet<std::uint64_t>)) +
                            sizeof(std::int32_t);
  const std::uint64_t point = sizeof(Coord3) + sizeof(Point3);
  return tet * (stuffing.first_tet(end) - stuffing.first_tet(begin)) +
         point * (stuffing.first_point(points_end(stuffing, end)) -
                  stuffing.first_point(begin));
}

template <class T>
std::span<T> grown(std::vector<T>& store, std::uint64_t count) {
  store.resize(count);
  return store;
}

void stop_if_cancelled(const Context& context) {
  if (context.cancelled) throw Error(ErrorCode::cancelled, "the run was interrupted");
}

/// The tetrahedra of some layers and all points they name.
template <class Index>
class Slab {
 public:
  void emit(const Stuffing& stuffing, std::int32_t begin, std::int32_t end,
            Context& context) {
    begin_ = begin;
    end_ = end;
    const std::int32_t behind = points_end(stuffing, end);
    first_point_ = stuffing.first_point(begin);
    stuffing.emit_points(begin, behind,
                         grown(points_, stuffing.first_point(behind) - first_point_),
                         context);
    stuffing.emit_tets(
        begin, end, grown(tets_, stuffing.first_tet(end) - stuffing.first_tet(begin)),
        context);
  }

  /// Labels and measures layer by layer, and adds up in their order, so that
  /// sums of rounded numbers are the same for every slab and thread.
  void measure(const Stuffing& stuffing, const Frame& frame, const Labeller& labeller,
               int threads, WrittenMesh& written, Checksum& checksum) {
    grown(world_, points_.size());
    if (labeller) grown(labels_, tets_.size());
    for_layers(begin_, points_end(stuffing, end_), threads, [&](std::int32_t layer) {
      const auto from = stuffing.first_point(layer) - first_point_;
      const auto to = stuffing.first_point(layer + 1) - first_point_;
      for (auto i = from; i < to; ++i) world_[i] = frame.world(points_[i]);
    });
    std::vector<Found> found(static_cast<std::size_t>(end_ - begin_));
    for_layers(begin_, end_, threads, [&](std::int32_t layer) {
      found[static_cast<std::size_t>(layer - begin_)] = measure(stuffing, labeller, layer);
    });
    for (const Found& layer : found) {
      written.lattice += layer.lattice;
      written.world += layer.world;
      checksum += layer.checksum;
    }
  }

  void write(MeshWriter& writer) const {
    writer.tets(std::span<const Tet<Index>>(tets_), labels_);
  }

 private:
  struct Found {
    Quality lattice, world;
    Checksum checksum;
  };

  Found measure(const Stuffing& stuffing, const Labeller& labeller, std::int32_t layer) {
    const std::uint64_t first = stuffing.first_tet(layer);
    const std::uint64_t slab_first = stuffing.first_tet(begin_);
    const std::span<const Tet<Index>> tets{tets_.data() + (first - slab_first),
                                           stuffing.first_tet(layer + 1) - first};
    if (labeller) {
      for (std::size_t i = 0; i < tets.size(); ++i)
        labels_[first - slab_first + i] = labeller(corners(tets[i]));
    }
    Found found;
    found.lattice = measure_lattice(points_, first_point_, tets);
    found.world = measure_world(world_, first_point_, tets);
    found.checksum.tets(first, tets);
    const std::uint64_t point = stuffing.first_point(layer);
    found.checksum.points(point, {points_.data() + (point - first_point_),
                                  stuffing.first_point(layer + 1) - point});
    return found;
  }

  [[nodiscard]] std::array<Coord3, 4> corners(const Tet<Index>& tet) const {
    return {points_[tet[0] - first_point_], points_[tet[1] - first_point_],
            points_[tet[2] - first_point_], points_[tet[3] - first_point_]};
  }

  std::int32_t begin_ = 0, end_ = 0;
  std::uint64_t first_point_ = 0;
  std::vector<Coord3> points_;
  std::vector<Point3> world_;
  std::vector<Tet<Index>> tets_;
  std::vector<std::int32_t> labels_;
};

void write_points(const Stuffing& stuffing, const Frame& frame, const Slabs& slabs,
                  MeshWriter& writer, Context& context, WrittenMesh& written) {
  std::vector<Coord3> points;
  std::vector<Point3> world;
  for (std::size_t s = 0; s + 1 < slabs.bounds.size(); ++s) {
    stop_if_cancelled(context);
    const std::uint64_t first = stuffing.first_point(slabs.bounds[s]);
    const std::uint64_t last = stuffing.first_point(slabs.bounds[s + 1]);
    {
      const Timer timer(written.emit_seconds);
      stuffing.emit_points(slabs.bounds[s], slabs.bounds[s + 1],
                           grown(points, last - first), context);
      grown(world, points.size());
      for (std::size_t i = 0; i < points.size(); ++i) world[i] = frame.world(points[i]);
    }
    const Timer timer(written.write_seconds);
    writer.points(world);
  }
}

template <class Index>
void write_tets(const Stuffing& stuffing, const Frame& frame, const Slabs& slabs,
                const Labeller& labeller, MeshWriter& writer, Context& context,
                WrittenMesh& written) {
  Checksum checksum;
  Slab<Index> slab;
  for (std::size_t s = 0; s + 1 < slabs.bounds.size(); ++s) {
    stop_if_cancelled(context);
    {
      const Timer timer(written.emit_seconds);
      slab.emit(stuffing, slabs.bounds[s], slabs.bounds[s + 1], context);
    }
    {
      const Timer timer(written.measure_seconds);
      slab.measure(stuffing, frame, labeller, context.threads, written, checksum);
    }
    const Timer timer(written.write_seconds);
    slab.write(writer);
  }
  written.checksum = checksum.value();
}

}  // namespace

Slabs cut_slabs(const Stuffing& stuffing, std::uint64_t max_bytes) {
  Slabs slabs;
  slabs.bounds.push_back(0);
  for (std::int32_t layer = 0; layer < stuffing.layers(); ++layer) {
    const std::int32_t begin = slabs.bounds.back();
    if (layer > begin && slab_bytes(stuffing, begin, layer + 1) > max_bytes)
      slabs.bounds.push_back(layer);
    slabs.bytes =
        std::max(slabs.bytes, slab_bytes(stuffing, slabs.bounds.back(), layer + 1));
  }
  slabs.bounds.push_back(stuffing.layers());
  return slabs;
}

WrittenMesh write_mesh(const Stuffing& stuffing, const Frame& frame, const Slabs& slabs,
                       const Labeller& labeller, MeshWriter& writer, Context& context) {
  WrittenMesh written;
  try {
    write_points(stuffing, frame, slabs, writer, context, written);
    if (fits_32_bits(stuffing))
      write_tets<std::uint32_t>(stuffing, frame, slabs, labeller, writer, context, written);
    else
      write_tets<std::uint64_t>(stuffing, frame, slabs, labeller, writer, context, written);
    stop_if_cancelled(context);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "out of memory while writing the mesh");
  }
  return written;
}

}  // namespace certet
