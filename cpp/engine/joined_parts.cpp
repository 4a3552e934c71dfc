#include "joined_parts.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "certet/error.hpp"
#include "layer_loop.hpp"

namespace certet::core {
namespace {

Layers<LayerJoins> find_joins(const PlusRuns& runs, const ZeroTets& zero_tets, Context& context) {
  Layers<LayerJoins> layers(runs.planes().window());
  for_each_layer(context, Stage::count, layers.window(), [&](std::int32_t k) {
    add_zero_vertices(runs, zero_tets, k, layers[k]);
    add_long_cuts(runs, k, layers[k]);
  });
  return layers;
}

/// Joins pairs: in the whole and, if both are of one of several materials, in that.
void join_pairs(const std::vector<PartPair>& pairs, const MeshParts& parts,
                DisjointSets& whole, DisjointSets& regions) {
  for (const auto& [a, b] : pairs) {
    whole.join(a, b);
    if (regions.size() != 0 && parts.material(a) == parts.material(b)) regions.join(a, b);
  }
}

FaultPoints faults_in(const Layers<LayerJoins>& layers) {
  FaultPoints faults;
  for (const LayerJoins& layer : layers) {
    faults.vertices.insert(faults.vertices.end(), layer.vertices.begin(), layer.vertices.end());
    faults.edges.insert(faults.edges.end(), layer.edges.begin(), layer.edges.end());
  }
  const auto make_set = [](auto& list) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  };
  make_set(faults.vertices);
  make_set(faults.edges);
  return faults;
}

}  // namespace

Material MeshParts::material(std::uint32_t part) const {
  return part < runs.size() ? runs.materials()[part]
                            : material_of_zero_tet(runs.planes(), zero_tets[part - runs.size()]);
}

MeshParts join_parts(const SignPlanes& planes, Context& context) {
  PlusRuns runs(planes, context);
  ZeroTets zero_tets(planes, context);
  const std::uint64_t count = std::uint64_t{runs.size()} + zero_tets.size();
  if (count > std::numeric_limits<std::uint32_t>::max())
    throw Error(ErrorCode::too_large, "the mesh is too large for its pieces to be counted");
  RunSets by_edges = runs.joined_by_edges(context);
  const Layers<LayerJoins> layers = find_joins(runs, zero_tets, context);
  MeshParts parts{std::move(runs),
                    std::move(zero_tets),
                    {std::move(by_edges.whole), DisjointSets(0)},
                    {std::move(by_edges.regions), DisjointSets(0)},
                    faults_in(layers)};
  JoinedSets& whole = parts.whole;
  JoinedSets& regions = parts.regions;
  whole.by_faces.grow(count);
  if (parts.runs.have_materials()) regions.by_faces.grow(count);
  for (const LayerJoins& layer : layers)
    join_pairs(layer.by_faces, parts, whole.by_faces, regions.by_faces);
  whole.by_vertices = whole.by_faces;
  regions.by_vertices = regions.by_faces;
  for (const LayerJoins& layer : layers)
    join_pairs(layer.by_vertices, parts, whole.by_vertices, regions.by_vertices);
  return parts;
}

}  // namespace certet::core
