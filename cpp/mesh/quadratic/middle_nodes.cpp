#include "certet/middle_nodes.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <new>
#include <variant>

#include "certet/buffer.hpp"
#include "certet/error.hpp"
#include "engine/parallel.hpp"

namespace certet {
namespace {

/// The edges whose lower ends are some points one behind the other.
struct EdgeLists {
  std::vector<std::uint64_t> first;  ///< of each point, from 0; and of all
  std::vector<std::uint32_t> reach;
};

/// Calls visit(lower, reach) for the edges of tetrahedra, again and again, whose lower ends are
/// from `begin` to `end`.
template <class Index, class Visit>
void visit_edges(std::span<const Tet<Index>> tets, std::uint64_t begin, std::uint64_t end,
                 const Visit& visit) {
  for (const Tet<Index>& tet : tets)
    for (const auto& [i, j] : tet_edges) {
      const std::uint64_t lower = std::min(tet[i], tet[j]), higher = std::max(tet[i], tet[j]);
      if (lower >= begin && lower < end) visit(lower - begin, higher - lower);
    }
}

/// Leaves each edge once.
EdgeLists without_copies(std::vector<std::uint64_t> ends, std::vector<std::uint32_t> reach) {
  EdgeLists lists;
  lists.first.reserve(ends.size() + 1);
  lists.first.push_back(0);
  auto from = reach.begin(), to = reach.begin();
  for (const std::uint64_t end : ends) {
    const auto stop = reach.begin() + static_cast<std::ptrdiff_t>(end);
    std::sort(from, stop);
    to = std::unique_copy(from, stop, to);
    from = stop;
    lists.first.push_back(static_cast<std::uint64_t>(to - reach.begin()));
  }
  reach.resize(lists.first.back());
  lists.reach = std::move(reach);
  return lists;
}

template <class Index>
EdgeLists edges_of(std::span<const Tet<Index>> tets, std::uint64_t begin, std::uint64_t end) {
  std::vector<std::uint64_t> ends(static_cast<std::size_t>(end - begin));
  std::uint64_t farthest = 0;
  visit_edges(tets, begin, end, [&](std::uint64_t lower, std::uint64_t reach) {
    ++ends[lower];
    farthest = std::max(farthest, reach);
  });
  if (farthest > std::numeric_limits<std::uint32_t>::max())
    throw Error(ErrorCode::too_large, "the numbers of two points of an edge are 2^32 apart");
  // Each place first holds where its edges begin, and then, one by one, where they end.
  std::uint64_t all = 0;
  for (std::uint64_t& place : ends) all += std::exchange(place, all);
  std::vector<std::uint32_t> reaches(all);
  visit_edges(tets, begin, end, [&](std::uint64_t lower, std::uint64_t reach) {
    reaches[ends[lower]++] = static_cast<std::uint32_t>(reach);
  });
  return without_copies(std::move(ends), std::move(reaches));
}

/// A tetrahedron of a layer has points of that and of the next one alone, or of some more where
/// the mesh is graded, so that the edges whose lower ends are in a layer are those of its
/// tetrahedra and of the layer before, or of as many.
template <class Index>
EdgeLists edges_of_layer(const Stuffing& stuffing, std::int32_t layer) {
  std::int32_t before = layer;
  while (before > 0 && stuffing.points_end(before) > layer) --before;
  Buffer<Tet<Index>> tets(stuffing.first_tet(layer + 1) - stuffing.first_tet(before));
  core::OneThread context;
  stuffing.emit_tets(before, layer + 1, std::span<Tet<Index>>(tets), context);
  return edges_of(std::span<const Tet<Index>>(tets), stuffing.first_point(layer),
                  stuffing.first_point(layer + 1));
}

MiddleNodes joined(std::vector<EdgeLists>& lists) {
  std::vector<std::uint64_t> first{0};
  std::vector<std::uint32_t> reach;
  for (EdgeLists& part : lists) {
    const std::uint64_t before = reach.size();
    for (std::size_t i = 1; i < part.first.size(); ++i) first.push_back(before + part.first[i]);
    reach.insert(reach.end(), part.reach.begin(), part.reach.end());
    part = {};
  }
  return {std::move(first), std::move(reach)};
}

template <class Index>
MiddleNodes nodes_of_layers(const Stuffing& stuffing, Context& context) {
  std::vector<EdgeLists> layers(static_cast<std::size_t>(stuffing.layers()));
  core::parallel_for(context, Stage::emit, stuffing.layers(), [&](std::int64_t layer) {
    layers[static_cast<std::size_t>(layer)] =
        edges_of_layer<Index>(stuffing, static_cast<std::int32_t>(layer));
  });
  return joined(layers);
}

template <class Index>
MiddleNodes nodes_of(std::uint64_t points, std::span<const Tet<Index>> tets) {
  for (const Tet<Index>& tet : tets)
    for (const Index point : tet)
      if (point >= points)
        throw Error(ErrorCode::bad_option, "a tetrahedron names a point that is not there");
  try {
    std::vector<EdgeLists> all;
    all.push_back(edges_of(tets, 0, points));
    return joined(all);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "out of memory for the middle nodes");
  }
}

}  // namespace

std::uint64_t MiddleNodes::between(std::uint64_t a, std::uint64_t b) const {
  const auto [lower, higher] = std::minmax(a, b);
  if (higher >= corners() || higher - lower > std::numeric_limits<std::uint32_t>::max())
    return count();
  const auto begin = reach_.begin() + static_cast<std::ptrdiff_t>(first_[lower]);
  const auto end = reach_.begin() + static_cast<std::ptrdiff_t>(first_[lower + 1]);
  const auto reach = static_cast<std::uint32_t>(higher - lower);
  const auto found = std::lower_bound(begin, end, reach);
  return found == end || *found != reach ? count()
                                         : static_cast<std::uint64_t>(found - reach_.begin());
}

Coord3 bend_of(std::span<const Bend> bends, std::uint64_t node) {
  const auto found = std::ranges::lower_bound(bends, node, {}, &Bend::node);
  return found == bends.end() || found->node != node ? Coord3{0, 0, 0} : found->by;
}

std::uint64_t MiddleNodes::bytes() const {
  return first_.size() * sizeof(std::uint64_t) + reach_.size() * sizeof(std::uint32_t) +
         bends_.size() * sizeof(Bend);
}

MiddleNodes middle_nodes(const Mesh& mesh, Context& context) {
  stop_if_cancelled(context);
  return std::visit(
      [&]<class Index>(const Buffer<Tet<Index>>& tets) {
        return nodes_of(mesh.points.size(), std::span<const Tet<Index>>(tets));
      },
      mesh.tets);
}

MiddleNodes middle_nodes(const Mesh& mesh) {
  Context context;
  return middle_nodes(mesh, context);
}

MiddleNodes middle_nodes(const Stuffing& stuffing, Context& context) {
  try {
    return stuffing.point_count() <= std::numeric_limits<std::uint32_t>::max()
               ? nodes_of_layers<std::uint32_t>(stuffing, context)
               : nodes_of_layers<std::uint64_t>(stuffing, context);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "out of memory for the middle nodes");
  }
}

MiddleNodes middle_nodes(std::uint64_t points, std::span<const Tet<std::uint64_t>> tets) {
  return nodes_of(points, tets);
}

/// As `Frame::world` does it, of a position between steps.
Point3 middle_in_world(const Frame& frame, Coord3 a, Coord3 b, Coord3 bend) {
  const double half = frame.size / (4.0 * steps);
  const auto middle = [half](std::int64_t p, std::int64_t q, std::int64_t by) {
    return half * static_cast<double>(p + q + by);
  };
  const Point3 at{middle(a.x, b.x, bend.x), middle(a.y, b.y, bend.y), middle(a.z, b.z, bend.z)};
  Point3 world;
  for (std::size_t r = 0; r < 3; ++r) {
    const auto& row = frame.axes[r];
    world[r] = frame.origin[r] + (row[0] * at[0] + row[1] * at[1] + row[2] * at[2]);
  }
  return world;
}

std::vector<Point3> middle_points(const Mesh& mesh, const MiddleNodes& middles) {
  try {
    std::vector<Point3> points(static_cast<std::size_t>(middles.count()));
    auto bend = middles.bends().begin();
    middles.for_each(0, middles.corners(), [&](std::uint64_t node, std::uint64_t a,
                                               std::uint64_t b) {
      const bool bent = bend != middles.bends().end() && bend->node == node;
      points[node] = middle_in_world(mesh.frame, mesh.points[a], mesh.points[b],
                                     bent ? (bend++)->by : Coord3{0, 0, 0});
    });
    return points;
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "out of memory for the middle nodes");
  }
}

}  // namespace certet
