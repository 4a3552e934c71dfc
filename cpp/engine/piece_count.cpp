#include "piece_count.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

#include "lattice/cell_tables.hpp"
#include "layer_loop.hpp"
#include "places.hpp"
#include "stencil_counts.hpp"
#include "zero_link.hpp"

namespace certet::core {
namespace {

/// A vertex of the lattice; they are ordered as the mesh's points are.
struct Vertex {
  std::int32_t k, j;
  Grid grid;
  std::int32_t i;
  friend auto operator<=>(const Vertex&, const Vertex&) = default;

  [[nodiscard]] Vertex to(std::size_t direction) const {
    const VertexRef ref = neighbor(grid, direction);
    return {k + ref.shift.z, j + ref.shift.y, ref.grid, i + ref.shift.x};
  }
};

/// What the zero vertices of one layer add to edges.
struct LayerZeros {
  std::vector<std::array<std::uint32_t, 2>> across_faces, at_vertices;  ///< pairs of runs
  std::vector<Vertex> vertices;               ///< without one fan
  std::vector<std::array<Vertex, 2>> edges;   ///< overfull, the earlier end first
};

class ZeroVisitor {
 public:
  explicit ZeroVisitor(const PlusRuns& runs) : runs_(runs), planes_(runs.planes()) {}

  LayerZeros visit(std::int32_t k) {
    LayerZeros found;
    for (std::int32_t j = 0; j < planes_.cells()[1]; ++j)
      for (const Grid grid : grids)
        for (int w = 0; w < planes_.words(); ++w)
          if (const std::uint64_t zero = planes_.zero(grid, j, k)[w]; zero != 0)
            visit_word({k, j, grid, 64 * w}, zero, found);
    return found;
  }

 private:
  /// The signs of the links are read 64 at once, as most zero vertices have others near.
  void visit_word(Vertex first, std::uint64_t zeros, LayerZeros& found) const {
    std::array<SignWord, direction_count> around;
    const SignRows rows(planes_, first.j, first.k);
    for (std::size_t d = 0; d < direction_count; ++d)
      around[d] = rows.at(neighbor(first.grid, d), first.i >> 6);
    for_each_bit(zeros, [&](int b) {
      LinkSet plus = 0;
      LinkSet zero = 0;
      for (std::size_t d = 0; d < direction_count; ++d) {
        plus |= static_cast<LinkSet>(around[d].plus >> b & 1) << d;
        zero |= static_cast<LinkSet>(around[d].zero >> b & 1) << d;
      }
      if (is_strict_disk(plus, zero)) return;
      Vertex v = first;
      v.i += b;
      add(v, plus, look_around(plus, zero), found);
    });
  }

  void add(const Vertex& v, LinkSet plus, const LinkFindings& link, LayerZeros& found) const {
    const auto run = [&](int d) {
      const Vertex to = v.to(static_cast<std::size_t>(d));
      return runs_.run_of(to.grid, to.i, to.j, to.k);
    };
    for (const auto& [a, b] : link.across_faces) found.across_faces.push_back({run(a), run(b)});
    const std::uint32_t first = run(std::countr_zero(plus));
    for_each_bit(plus & (plus - 1), [&](int d) { found.at_vertices.push_back({first, run(d)}); });
    if (!link.one_fan) found.vertices.push_back(v);
    for_each_bit(link.overfull_edges, [&](int d) {
      const Vertex to = v.to(static_cast<std::size_t>(d));
      if (v < to) found.edges.push_back({v, to});
    });
  }

  const PlusRuns& runs_;
  const SignPlanes& planes_;
};

/// In the order of layers, so that the first places are those of the lowest numbers.
void add_faults(const LayerZeros& layer, const WarpedLattice& warped, const Lattice& lattice,
                const Frame& frame, SurfaceFaults& surface) {
  const auto place = [&](const Vertex& v) { return frame.world(moved_place(warped, lattice, {v.grid, v.i, v.j, v.k})); };
  surface.vertices += layer.vertices.size();
  surface.edges += layer.edges.size();
  for (const Vertex& v : layer.vertices)
    if (surface.vertex_places.size() < most_places) surface.vertex_places.push_back(place(v));
  std::vector<std::array<Vertex, 2>> edges = layer.edges;
  std::ranges::sort(edges);
  for (const auto& [a, b] : edges)
    if (surface.edge_places.size() < most_places)
      surface.edge_places.push_back(middle(place(a), place(b)));
}

/// Counts the tetrahedra of one row of cells.
class PieceTets {
 public:
  PieceTets(const PlusRuns& runs, const std::vector<std::uint32_t>& piece_of,
            std::vector<std::uint64_t>& tets)
      : runs_(runs), piece_of_(piece_of), tets_(tets) {}

  void add_row(int j, int k) {
    const SignPlanes& planes = runs_.planes();
    const SignRows signs(planes, j, k);
    std::vector<RunCursor> cursors;
    cursors.reserve(cell_vertex_count);
    for (const VertexRef& v : cell.vertices) {
      const int y = std::min(j + v.shift.y, planes.cells()[1] - 1);
      const int z = std::min(k + v.shift.z, planes.cells()[2] - 1);
      cursors.emplace_back(planes.plus(v.grid, y, z), v.shift.x, runs_.first(v.grid, y, z));
    }
    for (int w = 0; w < planes.words(); ++w) add_word(signs, cursors, w);
  }

  void finish() {
    if (pending_ != 0) std::atomic_ref(tets_[piece_]).fetch_add(pending_, std::memory_order_relaxed);
    pending_ = 0;
  }

 private:
  void add_word(const SignRows& signs, std::vector<RunCursor>& cursors, int w) {
    std::array<SignWord, cell_vertex_count> vertex;
    std::uint64_t any_plus = 0;
    for (std::size_t v = 0; v < cell_vertex_count; ++v) {
      vertex[v] = signs.at(cell.vertices[v], w);
      cursors[v].next(w);
      any_plus |= vertex[v].plus;
    }
    if (any_plus == 0) return;
    for (const auto& corner : cell.corner) {
      const StencilCounts counts = stencil_counts(
          {vertex[corner[0]], vertex[corner[1]], vertex[corner[2]], vertex[corner[3]]});
      std::uint64_t left = counts.one;
      for (const std::size_t v : corner) {
        add_runs(left & vertex[v].plus, vertex[v].plus, counts, cursors[v]);
        left &= ~vertex[v].plus;
      }
    }
  }

  /// The tetrahedra at some plus vertices of a word, run by run.
  void add_runs(std::uint64_t at, std::uint64_t plus, const StencilCounts& counts,
                const RunCursor& cursor) {
    while (at != 0) {
      const int b = std::countr_zero(at);
      const int end = b + std::countr_one(plus >> b);
      const std::uint64_t run = end == 64 ? at : at & below(end);
      const auto count = [run](std::uint64_t bits) {
        return static_cast<std::uint64_t>(std::popcount(bits & run));
      };
      add(piece_of_[cursor.run(b)], count(counts.one) + count(counts.two) + count(counts.three));
      at &= ~run;
    }
  }

  void add(std::uint32_t piece, std::uint64_t tets) {
    if (piece != piece_) finish();
    piece_ = piece;
    pending_ += tets;
  }

  const PlusRuns& runs_;
  const std::vector<std::uint32_t>& piece_of_;
  std::vector<std::uint64_t>& tets_;
  std::uint32_t piece_ = 0;
  std::uint64_t pending_ = 0;
};

}  // namespace

Point3 middle(const Point3& a, const Point3& b) {
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])};
}

JoinedRuns join_runs(const PlusRuns& runs, const WarpedLattice& warped, const Lattice& lattice,
                     const Frame& frame, Context& context) {
  DisjointSets by_edges = runs.joined_by_edges(context);
  Layers<LayerZeros> layers(warped.planes.window());
  for_each_layer(context, Stage::count, warped.planes.window(),
                 [&](std::int32_t k) { layers[k] = ZeroVisitor(runs).visit(k); });
  JoinedRuns joined{std::move(by_edges), DisjointSets(0), {}};
  for (const LayerZeros& layer : layers) {
    for (const auto& [a, b] : layer.across_faces) joined.by_faces.join(a, b);
    add_faults(layer, warped, lattice, frame, joined.surface);
  }
  joined.by_vertices = joined.by_faces;
  for (const LayerZeros& layer : layers)
    for (const auto& [a, b] : layer.at_vertices) joined.by_vertices.join(a, b);
  return joined;
}

NumberedSets number_sets(DisjointSets& sets) {
  NumberedSets numbered;
  numbered.of.resize(sets.size());
  for (std::uint32_t n = 0; n < sets.size(); ++n) {
    const std::uint32_t least = sets.find(n);
    numbered.of[n] = least == n ? numbered.count++ : numbered.of[least];
  }
  return numbered;
}

std::vector<std::uint64_t> count_tets_of_pieces(const PlusRuns& runs,
                                                const std::vector<std::uint32_t>& piece_of,
                                                std::size_t pieces, Context& context) {
  std::vector<std::uint64_t> tets(pieces, 0);
  for_each_layer(context, Stage::count, runs.planes().window(), [&](std::int32_t k) {
    PieceTets layer(runs, piece_of, tets);
    for (int j = 0; j < runs.planes().cells()[1]; ++j) layer.add_row(j, k);
    layer.finish();
  });
  return tets;
}

Pieces count_pieces(const WarpedLattice& warped, const Lattice& lattice, std::uint64_t tets,
                    const Frame& frame, Context& context) {
  const PlusRuns runs(warped.planes, context);
  JoinedRuns joined = join_runs(runs, warped, lattice, frame, context);
  Pieces pieces;
  pieces.surface = std::move(joined.surface);
  const NumberedSets by_faces = number_sets(joined.by_faces);
  pieces.whole = {by_faces.count, number_sets(joined.by_vertices).count};
  pieces.largest = tets;
  if (by_faces.count > 1)
    pieces.largest =
        std::ranges::max(count_tets_of_pieces(runs, by_faces.of, by_faces.count, context));
  return pieces;
}

}  // namespace certet::core
