#include "certet/survey.hpp"

#include <algorithm>
#include <limits>
#include <new>

#include "certet/buffer.hpp"
#include "certet/error.hpp"
#include "engine/parallel.hpp"
#include "mesh/boundary.hpp"

namespace certet {
namespace {

using quality::RegionCounts;

/// What is found in one layer of tetrahedra.  Faces that lie between two layers
/// are in both.
struct LayerFindings {
  RegionCounts counts;
  std::vector<BoundaryFace> faces;
};

/// For what the engine does within a single layer.
struct OneThread : Context {
  OneThread() { threads = 1; }
};

template <class Index>
class LayerSurvey {
 public:
  LayerSurvey(const Stuffing& stuffing, const Labeller& labeller, const BorderTest& border,
              std::int32_t layer);

  LayerFindings find();

 private:
  void find_faces(std::vector<BoundaryFace>& faces) const;
  void find_patches(std::vector<BoundaryFace>& faces) const;
  void count_labels(RegionCounts& counts) const;
  [[nodiscard]] Coord3 position(std::uint64_t point) const { return points_[point - first_point_]; }

  const Labeller& labeller_;
  const BorderTest& border_;
  std::uint64_t first_point_, first_tet_;
  Buffer<Tet<Index>> tets_;
  Buffer<std::uint8_t> on_surface_;
  Buffer<Coord3> points_;  ///< empty where nobody asks for them
};

template <class Index>
LayerSurvey<Index>::LayerSurvey(const Stuffing& stuffing, const Labeller& labeller,
                                const BorderTest& border, std::int32_t layer)
    : labeller_(labeller), border_(border), first_point_(stuffing.first_point(layer)),
      first_tet_(stuffing.first_tet(layer)),
      tets_(stuffing.first_tet(layer + 1) - first_tet_) {
  const std::int32_t behind = std::min(layer + 2, stuffing.layers());
  const std::uint64_t points = stuffing.first_point(behind) - first_point_;
  OneThread context;
  stuffing.emit_tets(layer, layer + 1, std::span<Tet<Index>>(tets_), context);
  on_surface_ = Buffer<std::uint8_t>(points);
  stuffing.mark_surface(layer, behind, on_surface_, context);
  if (!labeller && !border) return;
  points_ = Buffer<Coord3>(points);
  stuffing.emit_points(layer, behind, points_, context);
}

template <class Index>
LayerFindings LayerSurvey<Index>::find() {
  LayerFindings found;
  find_faces(found.faces);
  if (border_) find_patches(found.faces);
  if (labeller_)
    count_labels(found.counts);
  else if (!tets_.empty())
    found.counts.add(only_label, tets_.size());
  return found;
}

/// A face that no other tetrahedron shares has its three points on the surface
/// (theorem BoundaryOnSurface), so that no other faces need to be compared.
template <class Index>
void LayerSurvey<Index>::find_faces(std::vector<BoundaryFace>& faces) const {
  for (std::size_t i = 0; i < tets_.size(); ++i) {
    std::array<int, 4> marks;
    for (std::size_t v = 0; v < 4; ++v) marks[v] = on_surface_[tets_[i][v] - first_point_];
    const int sum = marks[0] + marks[1] + marks[2] + marks[3];
    if (sum < 3) continue;
    for (std::uint8_t opposite = 0; opposite < 4; ++opposite)
      if (sum - marks[opposite] == 3)
        faces.push_back(quality::face_of(tets_[i], first_tet_ + i, opposite));
  }
  quality::keep_single_faces(faces);
}

template <class Index>
void LayerSurvey<Index>::find_patches(std::vector<BoundaryFace>& faces) const {
  for (BoundaryFace& face : faces)
    if (std::ranges::all_of(face.points, [&](std::uint64_t p) { return border_(position(p)); }))
      face.patch = Patch::border;
}

template <class Index>
void LayerSurvey<Index>::count_labels(RegionCounts& counts) const {
  std::array<std::array<Coord3, 4>, 256> corners;
  std::array<std::int32_t, 256> labels;
  for (std::size_t begin = 0; begin < tets_.size(); begin += corners.size()) {
    const std::size_t count = std::min(corners.size(), tets_.size() - begin);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t v = 0; v < 4; ++v) corners[i][v] = position(tets_[begin + i][v]);
    labeller_(std::span(corners).first(count), std::span(labels).first(count));
    counts.add(std::span<const std::int32_t>(labels).first(count));
  }
}

template <class Index>
Survey survey_layers(const Stuffing& stuffing, const Labeller& labeller,
                     const BorderTest& border, Context& context) {
  std::vector<LayerFindings> layers(static_cast<std::size_t>(stuffing.layers()));
  core::parallel_for(context, Stage::emit, stuffing.layers(), [&](std::int64_t layer) {
    layers[static_cast<std::size_t>(layer)] =
        LayerSurvey<Index>(stuffing, labeller, border, static_cast<std::int32_t>(layer)).find();
  });
  Survey survey;
  RegionCounts counts;
  for (LayerFindings& layer : layers) {
    counts += layer.counts;
    survey.boundary.insert(survey.boundary.end(), layer.faces.begin(), layer.faces.end());
    layer.faces = {};
  }
  quality::keep_single_faces(survey.boundary);
  survey.regions = counts.regions();
  return survey;
}

}  // namespace

Survey survey(const Stuffing& stuffing, const Labeller& labeller, const BorderTest& border,
              Context& context) {
  try {
    return stuffing.point_count() <= std::numeric_limits<std::uint32_t>::max()
               ? survey_layers<std::uint32_t>(stuffing, labeller, border, context)
               : survey_layers<std::uint64_t>(stuffing, labeller, border, context);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "out of memory while looking for the mesh's boundary");
  }
}

}  // namespace certet
