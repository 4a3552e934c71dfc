#include "label_trial.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "certet/checksum.hpp"
#include "certet/label_warnings.hpp"
#include "certet/stuffing.hpp"
#include "certet/survey.hpp"
#include "certet/write_mesh.hpp"
#include "labelled_mesh.hpp"
#include "planted.hpp"
#include "samples.hpp"
#include "soak/thin/overlap.hpp"
#include "subject.hpp"

namespace labelled {
namespace {

using certet::Point3;
using Labels = std::set<std::int32_t>;

/// Keeps the labels of what is written slab by slab.
class LabelKeeper final : public certet::MeshWriter {
 public:
  void points(std::span<const Point3>) override {}
  void tets(std::span<const Tet> tets, std::span<const std::int32_t> labels) override {
    count_ += tets.size();
    labels_.insert(labels_.end(), labels.begin(), labels.end());
  }
  void tets(std::span<const certet::Tet<std::uint64_t>>, std::span<const std::int32_t>) override {}
  void finish() override {}

  std::size_t count_ = 0;
  std::vector<std::int32_t> labels_;
};

/// Judges one mesh; every fault is a sentence.
class Judge {
 public:
  Judge(const Subject& subject, const Samples& samples, const LabelledMesh& mesh, Verdict& verdict)
      : subject_(subject), samples_(samples), mesh_(mesh), verdict_(verdict),
        present_(mesh.label_set()), union_surface_(surface_of(mesh.tets)) {
    verdict_.tets = mesh.tets.size();
    verdict_.regions = present_.size();
    for (const std::int32_t label : present_)
      surfaces_[label] = surface_of(region_of(mesh_, {label}).tets);
  }

  void check_tets() {
    const exact::AngleRange& range = subject_.method == certet::Method::midpoint
                                         ? exact::midpoint_range : exact::angles_range;
    std::vector<exact::Tet> tets;
    for (const Tet& tet : mesh_.tets) {
      tets.push_back(mesh_.corners(tet));
      if (exact::six_volume(tets.back()) <= 0) return fault("a tetrahedron is not positive");
      for (const exact::Dihedral& angle : exact::dihedrals(tets.back())) {
        verdict_.min_dihedral = std::min(verdict_.min_dihedral, double(angle.degrees()));
        verdict_.max_dihedral = std::max(verdict_.max_dihedral, double(angle.degrees()));
        if (!range.contains(angle)) return fault("an angle is out of range");
      }
    }
    const thin::Overlaps overlap = thin::overlaps(tets);
    verdict_.pairs = overlap.looked_at;
    if (overlap.found != 0) fault(std::to_string(overlap.found) + " pairs of tetrahedra overlap");
  }

  /// Each is used, and by itself.
  void check_points() {
    std::vector<bool> used(mesh_.points.size());
    for (const Tet& tet : mesh_.tets)
      for (const std::uint32_t p : tet) used[p] = true;
    if (std::ranges::count(used, false) != 0) fault("a point belongs to no tetrahedron");
    for (std::size_t p = 0; p < mesh_.points.size(); ++p)
      if (!places_.emplace(mesh_.points[p], p).second) return fault("a point is at the place of another");
  }

  /// A triangle of a region's surface is one of just one other region's, which sees it the
  /// other way round, or of the surface of all together.
  void check_interfaces(const certet::Survey& survey) {
    std::map<Triangle, std::vector<std::int32_t>> owners;
    for (const auto& [label, surface] : surfaces_)
      for (const Triangle& t : surface) owners[t].push_back(label);
    std::map<std::array<std::int32_t, 2>, std::uint64_t> shared;
    std::vector<Triangle> alone;
    for (const auto& [triangle, labels] : owners) {
      const auto behind = owners.find(turned(triangle));
      if (labels.size() != 1) return fault("two regions are on one side of a triangle");
      if (behind == owners.end()) alone.push_back(triangle);
      else if (labels[0] < behind->second[0]) ++shared[{labels[0], behind->second[0]}];
    }
    std::vector<Triangle> outer = union_surface_;
    std::ranges::sort(outer);
    if (alone != outer) fault("what regions do not share is not the surface of all of them");
    verdict_.interfaces = shared.size();
    std::map<std::array<std::int32_t, 2>, std::uint64_t> told;
    for (const certet::Interface& one : survey.interfaces) told[one.labels] = one.faces.size();
    if (told != shared) fault("the interfaces that are told are other ones");
    if (survey.boundary.size() != outer.size()) fault("the boundary that is told is another one");
  }

  /// Each region's, and that of all together.
  void check_surfaces() {
    for (const auto& [label, surface] : surfaces_) {
      const std::string name = "the surface of label " + std::to_string(label);
      const std::uint64_t pinches = check_manifold(name, surface, material_of(label));
      if (pinches > 0) touching_.insert(label);
      verdict_.region_pinches += pinches;
      check_volume(name, surface, {label});
    }
    verdict_.outer_pinches = check_manifold("the surface of all regions", union_surface_, 0);
    check_volume("the surface of all regions", union_surface_, present_);
  }

  /// All tetrahedra around a vertex are there, and of its material, where that is all around.
  void check_inside() {
    std::vector<int> around(mesh_.points.size()), strange(mesh_.points.size());
    std::map<std::size_t, std::int32_t> deep;
    for (const Coord3 v : samples_.vertices()) {
      const certet::Material material = samples_.at(v);
      if (material == 0 || samples_.around(v) != MaterialSet{1} << material) continue;
      const auto point = places_.find(certet::steps * v);
      if (point == places_.end()) return fault("a lattice point inside is not in the mesh");
      deep.emplace(point->second, label_of(material));
    }
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t)
      for (const std::uint32_t p : mesh_.tets[t]) {
        ++around[p];
        if (const auto found = deep.find(p); found != deep.end())
          strange[p] += mesh_.labels[t] != found->second;
      }
    for (const auto& [point, label] : deep) {
      if (around[point] != 24)
        return fault(std::to_string(around[point]) + " tetrahedra, not 24, are around a lattice point");
      if (strange[point] != 0) return fault("a tetrahedron is not of the label all around it");
    }
  }

  /// Each region has the pieces of its samples by faces, and their tunnels and cavities where
  /// it does not touch itself.
  void check_shapes() {
    for (std::size_t m = 1; m <= subject_.domain->labels().size(); ++m) {
      const std::int32_t label = label_of(static_cast<certet::Material>(m));
      const topology::Shape samples = samples_.shape(MaterialSet{1} << m);
      verdict_.pieces += samples.pieces;
      verdict_.tunnels += samples.tunnels;
      verdict_.cavities += samples.cavities;
      const settling::Tets region = region_of(mesh_, {label});
      const topology::Shape made = topology::of_mesh(region);
      if (!touching_.contains(label) && made != samples)
        fault("label " + std::to_string(label) + " has " + text(made) + ", and its samples " + text(samples));
      if (topology::pieces_by_faces(region) != samples.pieces)
        fault("pieces of label " + std::to_string(label) + " by faces are not those of its samples");
      check_voxels(label, samples.pieces);
    }
    const topology::Shape all = samples_.shape(~MaterialSet{1});
    const settling::Tets whole = region_of(mesh_, present_);
    if (topology::of_mesh(whole).pieces != all.pieces)
      fault("pieces of all regions together are not those of the samples");
    verdict_.parted = static_cast<std::uint64_t>(topology::pieces_by_faces(whole) - all.pieces);
  }

  /// Labels are lost where voxels may be, and then they are named.
  void check_names(const certet::Mesh& mesh) {
    if (!subject_.image) return;
    const std::vector<std::string> told = certet::warnings_on_labels(*subject_.image->image, {}, mesh);
    for (const auto& [label, pieces] : subject_.image->pieces) {
      const std::string start = "label " + std::to_string(label) + " (";
      const bool named = std::ranges::any_of(told, [&](const auto& t) { return t.starts_with(start); });
      if (present_.contains(label) == named && verdict_.lost < 8)
        fault("label " + std::to_string(label) + (named ? " is called lost" : " is lost and not named"));
      verdict_.lost += !present_.contains(label);
    }
    if (verdict_.lost > 0 && subject_.image->fineness != Fineness::coarser) fault("a label is lost");
  }

  /// Written slab by slab the mesh is the same, down to its checksum.
  void check_stream(const certet::Stuffing& stuffing, Plant plant, certet::Context& context) {
    verdict_.streamed = 1;
    LabelKeeper keeper;
    const certet::WrittenMesh written = certet::write_mesh(
        stuffing, subject_.frame, certet::cut_slabs(stuffing, mesh_.tets.size() % 3 * 60'000), keeper,
        context, {}, true);
    std::vector<Coord3> points = mesh_.points;
    if (plant == Plant::streamed_step) points.back().y += 1;
    certet::Checksum sum;
    sum.points(0, points);
    sum.tets(0, std::span<const Tet>(mesh_.tets));
    if (written.checksum != sum.value()) fault("streamed: the checksum is another one");
    if (keeper.labels_ != mesh_.labels) fault("streamed: the labels are other ones");
  }

 private:
  void fault(std::string sentence) { verdict_.faults.push_back(std::move(sentence)); }
  static std::string text(const topology::Shape& s) {
    return std::to_string(s.pieces) + " pieces, " + std::to_string(s.tunnels) + " tunnels, " +
           std::to_string(s.cavities) + " cavities";
  }
  [[nodiscard]] std::int32_t label_of(certet::Material material) const {
    return subject_.domain->labels()[static_cast<std::size_t>(material) - 1];
  }

  [[nodiscard]] certet::Material material_of(std::int32_t label) const {
    const auto labels = subject_.domain->labels();
    return 1 + static_cast<certet::Material>(std::ranges::find(labels, label) - labels.begin());
  }

  /// A surface is closed, and a manifold but for points in which what is of the material
  /// touches itself.  \returns how many these are.
  std::uint64_t check_manifold(const std::string& name, const std::vector<Triangle>& surface,
                               certet::Material material) {
    const SurfaceCounts counts = counts_of(surface);
    if (counts.open_edges != 0) fault(name + " is open");
    if (counts.crowded_edges != 0)
      fault(name + " has " + std::to_string(counts.crowded_edges) + " edges in more than two triangles");
    if (!std::ranges::all_of(counts.pinched, [&](std::uint32_t p) {
          return samples_.may_touch_itself(material, mesh_.points[p]);
        }))
      fault(name + " is no manifold at a vertex where it should be");
    return counts.pinched.size();
  }

  /// What a closed surface has within is what its tetrahedra have, and lies within what the
  /// samples leave open.
  void check_volume(const std::string& name, const std::vector<Triangle>& surface, const Labels& labels) {
    exact::Wide sum = 0;
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t)
      if (labels.contains(mesh_.labels[t])) sum += exact::six_volume(mesh_.corners(mesh_.tets[t]));
    if (sum != six_volume_within(mesh_, surface)) fault(name + " has another volume within");
    MaterialSet materials = 0;
    for (std::size_t m = 1; m <= subject_.domain->labels().size(); ++m)
      if (labels.contains(label_of(static_cast<certet::Material>(m)))) materials |= MaterialSet{1} << m;
    const auto [least, most] = samples_.volume(materials);
    if (sum < least || sum > most) fault(name + " has a volume that its samples do not allow");
  }

  /// Voxels that touch at edges and corners alone may hang together or not; smoothed ones also
  /// at a distance, which is counted.  Finer lattices may have islets beside smoothed ones.
  void check_voxels(std::int32_t label, std::int64_t pieces) {
    if (!subject_.image) return;
    const auto found = subject_.image->pieces.find(label);
    if (found == subject_.image->pieces.end()) return fault("there is a label that no voxel has");
    const auto [by_corners, by_faces] = found->second;
    const auto& [image, all, smooth, fineness] = *subject_.image;
    if (fineness == Fineness::coarser || (smooth && fineness == Fineness::finer)) return;
    if (pieces < (smooth ? 1 : by_corners) || pieces > by_faces)
      fault("label " + std::to_string(label) + " has " + std::to_string(pieces) + " pieces, and " +
            std::to_string(by_corners) + " to " + std::to_string(by_faces) + " in the image");
    verdict_.joined += static_cast<std::uint64_t>(std::max<std::int64_t>(0, by_corners - pieces));
  }

  const Subject& subject_;
  const Samples& samples_;
  const LabelledMesh& mesh_;
  Verdict& verdict_;
  Labels present_;
  Labels touching_;  ///< whose region touches itself in a point
  std::vector<Triangle> union_surface_;
  std::map<std::int32_t, std::vector<Triangle>> surfaces_;
  std::map<Coord3, std::size_t> places_;
};

LabelledMesh plain(const certet::Mesh& mesh) {
  const auto& tets = std::get<0>(mesh.tets);
  return {{mesh.points.begin(), mesh.points.end()}, {tets.begin(), tets.end()},
          {mesh.labels.begin(), mesh.labels.end()}};
}

}  // namespace

Verdict judge(std::uint64_t seed, std::uint64_t number, Plant plant) {
  Verdict verdict;
  const Subject subject = make_subject(seed, number);
  const Samples samples(*subject.domain, subject.lattice);
  certet::Context context;
  context.threads = 1 + static_cast<int>(number % 2);
  const std::unique_ptr<certet::Domain> other =
      plant == Plant::lone_sample ? with_lone_sample(*subject.domain, samples) : nullptr;
  const certet::Stuffing stuffing(other ? *other : *subject.domain, subject.lattice,
                                  subject.method, context);
  const certet::Mesh made = certet::emit(stuffing, subject.frame, context);
  LabelledMesh mesh = plain(made);
  if (!mesh.tets.empty()) spoil(mesh, samples, plant);
  Judge judge(subject, samples, mesh, verdict);
  judge.check_points();
  judge.check_tets();
  judge.check_interfaces(certet::survey(stuffing, context));
  judge.check_surfaces();
  judge.check_inside();
  judge.check_shapes();
  judge.check_names(made);
  if (number / 8 % 4 == 0) judge.check_stream(stuffing, plant, context);
  return verdict;
}

}  // namespace labelled
