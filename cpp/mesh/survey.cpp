#include "certet/survey.hpp"

#include <algorithm>
#include <limits>
#include <new>
#include <utility>
#include <variant>

#include "certet/buffer.hpp"
#include "certet/error.hpp"
#include "certet/patches.hpp"
#include "engine/border.hpp"
#include "engine/emit.hpp"
#include "engine/parallel.hpp"
#include "mesh/boundary.hpp"

namespace certet {
namespace {

using core::RegionCounts;

/// What is found in one layer of tetrahedra.  Faces that lie between two layers
/// are in both.
struct LayerFindings {
  RegionCounts counts;
  std::vector<BoundaryFace> faces;
  std::vector<core::InnerFace> inner;
  std::vector<core::DoubtfulFace> doubtful;
};

template <class Index>
class LayerSurvey {
 public:
  LayerSurvey(const Stuffing& stuffing, const core::BorderSides& border, std::int32_t layer);

  /// The materials of the layer go to `runs`, where there are labels.
  LayerFindings find(MaterialRuns& runs);

 private:
  void find_faces(LayerFindings& found) const;
  void find_patches(LayerFindings& found) const;
  void find_materials(MaterialRuns& runs, RegionCounts& counts);
  [[nodiscard]] std::int32_t label_of(std::size_t tet) const {
    return labels_.empty() ? only_label : labels_[tet];
  }

  const Stuffing& stuffing_;
  const core::BorderSides& border_;
  std::int32_t layer_;
  core::OneThread context_;
  std::uint64_t first_point_, first_tet_;
  Buffer<Tet<Index>> tets_;
  Buffer<std::uint8_t> on_surface_;
  Buffer<Coord3> points_;  ///< empty where nobody asks for them
  Buffer<std::int32_t> labels_;  ///< empty where there are none
};

template <class Index>
LayerSurvey<Index>::LayerSurvey(const Stuffing& stuffing, const core::BorderSides& border,
                                std::int32_t layer)
    : stuffing_(stuffing), border_(border), layer_(layer),
      first_point_(stuffing.first_point(layer)), first_tet_(stuffing.first_tet(layer)),
      tets_(stuffing.first_tet(layer + 1) - first_tet_) {
  const std::int32_t behind = stuffing.points_end(layer + 1);
  const std::uint64_t points = stuffing.first_point(behind) - first_point_;
  stuffing.emit_tets(layer, layer + 1, std::span<Tet<Index>>(tets_), context_);
  on_surface_ = Buffer<std::uint8_t>(points);
  stuffing.mark_surface(layer, behind, on_surface_, context_);
  if (stuffing.labels().empty() && border_.empty()) return;
  points_ = Buffer<Coord3>(points);
  stuffing.emit_points(layer, behind, points_, context_);
}

template <class Index>
LayerFindings LayerSurvey<Index>::find(MaterialRuns& runs) {
  LayerFindings found;
  if (!stuffing_.labels().empty())
    find_materials(runs, found.counts);
  else if (!tets_.empty())
    found.counts.add(only_label, tets_.size());
  find_faces(found);
  if (!border_.empty()) find_patches(found);
  return found;
}

/// A face that no other tetrahedron shares has its three points on the surface
/// (theorem BoundaryOnSurface), and so has one between two materials that are cut where
/// they meet, so that no other faces need to be compared.
template <class Index>
void LayerSurvey<Index>::find_faces(LayerFindings& found) const {
  for (std::size_t i = 0; i < tets_.size(); ++i) {
    std::array<int, 4> marks;
    for (std::size_t v = 0; v < 4; ++v) marks[v] = on_surface_[tets_[i][v] - first_point_];
    const int sum = marks[0] + marks[1] + marks[2] + marks[3];
    if (sum < 3) continue;
    for (std::uint8_t opposite = 0; opposite < 4; ++opposite)
      if (sum - marks[opposite] == 3)
        found.faces.push_back(core::face_of(tets_[i], first_tet_ + i, opposite, label_of(i)));
  }
  core::keep_single_faces(found.faces, found.inner);
  if (!stuffing_.has_interfaces()) found.inner.clear();
}

template <class Index>
void LayerSurvey<Index>::find_patches(LayerFindings& found) const {
  found.doubtful = core::put_on_border(found.faces, [&](std::uint64_t point) {
    return border_.at(points_[point - first_point_]);
  });
  if (!stuffing_.has_interfaces()) found.doubtful.clear();
}

template <class Index>
void LayerSurvey<Index>::find_materials(MaterialRuns& runs, RegionCounts& counts) {
  Buffer<std::int32_t>& materials = labels_ = Buffer<std::int32_t>(tets_.size());
  if (stuffing_.has_interfaces())
    stuffing_.emit_materials(layer_, layer_ + 1, materials, context_);
  else
    stuffing_.emit_materials(layer_, layer_ + 1, points_, std::span<const Tet<Index>>(tets_),
                             materials, context_);
  runs.put(layer_, materials);
  core::labels_in_place(
      std::span(materials), stuffing_.labels(),
      [&](std::int32_t label, std::uint64_t count) { counts.add(label, count); });
}

template <class Index>
Survey survey_layers(const Stuffing& stuffing, Context& context, const Frame& frame) {
  std::vector<LayerFindings> layers(static_cast<std::size_t>(stuffing.layers()));
  MaterialRuns runs(stuffing.labels().empty() ? 0 : stuffing.layers());
  const core::BorderSides border(stuffing.border(), facts(stuffing.method()).cuts, frame);
  core::parallel_for(context, Stage::emit, stuffing.layers(), [&](std::int64_t layer) {
    layers[static_cast<std::size_t>(layer)] =
        LayerSurvey<Index>(stuffing, border, static_cast<std::int32_t>(layer)).find(runs);
  });
  Survey survey;
  RegionCounts counts;
  std::vector<core::InnerFace> inner;
  std::vector<core::DoubtfulFace> doubtful;
  for (LayerFindings& layer : layers) {
    counts += layer.counts;
    survey.boundary.insert(survey.boundary.end(), layer.faces.begin(), layer.faces.end());
    inner.insert(inner.end(), layer.inner.begin(), layer.inner.end());
    layer.faces = {};
    doubtful.insert(doubtful.end(), layer.doubtful.begin(), layer.doubtful.end());
    layer.inner = {};
    layer.doubtful = {};
  }
  core::keep_single_faces(survey.boundary, inner);
  if (stuffing.has_interfaces()) survey.interfaces = core::interfaces_of(std::move(inner));
  core::put_on_border(survey, doubtful);
  survey.regions = counts.regions();
  survey.materials = std::move(runs);
  return survey;
}

}  // namespace

Survey survey(const Stuffing& stuffing, Context& context, const Frame& frame) {
  try {
    return stuffing.point_count() <= std::numeric_limits<std::uint32_t>::max()
               ? survey_layers<std::uint32_t>(stuffing, context, frame)
               : survey_layers<std::uint64_t>(stuffing, context, frame);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "out of memory while looking for the mesh's boundary");
  }
}

void find_sides(Survey& survey, const Mesh& mesh, const Frame& frame) {
  for (BoundaryFace& face : survey.boundary) face.patch = Patch::surface, face.is_cut_off = false;
  const core::BorderSides border(mesh.border, facts(mesh.method).cuts, frame);
  const auto doubtful = core::put_on_border(survey.boundary, [&](std::uint64_t point) {
    return border.at(mesh.points[static_cast<std::size_t>(point)]);
  });
  core::put_on_border(survey, doubtful);
}

Survey survey(const Mesh& mesh, Context& context) {
  Survey found = std::visit(
      [&]<class Index>(const Buffer<Tet<Index>>& tets) {
        return survey(mesh.points.size(), std::span<const Tet<Index>>(tets), mesh.labels, context);
      },
      mesh.tets);
  name_regions(found, mesh.names);
  if (!facts(mesh.method).interfaces) found.interfaces.clear();
  find_sides(found, mesh, mesh.frame);
  const auto place = [&](std::uint64_t point) {
    return mesh.frame.world(mesh.points[static_cast<std::size_t>(point)]);
  };
  name_patches(found, mesh.patches, mesh.frame.size, place);
  return found;
}

}  // namespace certet
