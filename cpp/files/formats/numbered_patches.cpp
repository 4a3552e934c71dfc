#include "numbered_patches.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "sheets.hpp"

namespace certet::formats {
namespace {

using Face = std::array<std::uint64_t, 3>;

constexpr std::int64_t border_number = Sheets::number_of(Patch::border);
constexpr std::int64_t first_side = Sheets::number_of(Patch::xmin);

Survey survey_of(const FileMesh& mesh) {
  Context context;
  return survey(mesh.points.size(), std::span<const Tet<std::uint64_t>>(mesh.tets), mesh.labels,
                context);
}

Face sorted(Face face) {
  std::ranges::sort(face);
  return face;
}

/// The points of faces, in order, for looking up.
class KnownFaces {
 public:
  void add(std::span<const BoundaryFace> faces) {
    for (const BoundaryFace& face : faces) known_.push_back(sorted(face.points));
  }
  void finish() { std::ranges::sort(known_); }
  [[nodiscard]] bool hold(const std::vector<Face>& faces) const {
    return std::ranges::all_of(faces, [this](const Face& face) {
      return std::ranges::binary_search(known_, sorted(face));
    });
  }

 private:
  std::vector<Face> known_;
};

KnownFaces interfaces_in(const Survey& found) {
  KnownFaces known;
  for (const Interface& interface : found.interfaces) known.add(interface.faces);
  known.finish();
  return known;
}

KnownFaces boundary_in(const Survey& found) {
  KnownFaces known;
  known.add(found.boundary);
  known.finish();
  return known;
}

/// What follows `border`, as far as it is called by number alone.
std::string name_of(std::int64_t number) {
  return number < Sheets::first_behind_sides
             ? std::string(patch_names[static_cast<std::size_t>(number - 1)])
             : "patch_" + std::to_string(number);
}

}  // namespace

void NumberedPatches::add(const Face& face, std::int64_t number) {
  faces_[number].push_back(face);
}

/// Whether faces look, all together, along the axis of a side, out of the box.  This costs less
/// than to find out where in the mesh they are.
bool NumberedPatches::is_side(const FileMesh& mesh, std::int64_t number,
                              const Faces& faces) const {
  constexpr double most_of = 0.5;
  const auto axis = static_cast<std::size_t>(number - first_side) / 2;
  double along = 0, area = 0;
  for (const Face& face : faces) {
    if (!std::ranges::all_of(face, [&](std::uint64_t p) { return p < mesh.points.size(); })) return false;
    const Point3 &a = mesh.points[face[0]], &b = mesh.points[face[1]], &c = mesh.points[face[2]];
    Point3 normal;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      normal[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
    }
    along += normal[axis];
    area += std::hypot(normal[0], normal[1], normal[2]);
  }
  return ((number - first_side) % 2 == 0 ? -along : along) > most_of * area;
}

/// Whether there may be other patches than `surface` and `border`: numbers from 3 to 8 are those
/// of sides or, where there are none, behind a gap comes what would else follow from 3 on.
bool NumberedPatches::may_have_sides(const FileMesh& mesh) const {
  const auto begin = faces_.lower_bound(first_side);
  const auto end = faces_.lower_bound(Sheets::first_behind_sides);
  return begin != faces_.end() &&
         std::all_of(begin, end, [&](const auto& one) { return is_side(mesh, one.first, one.second); });
}

/// \returns whether all faces are where their numbers say: those of patches on the boundary, and
/// behind them, to the end, those of interfaces.
bool NumberedPatches::give_all_patches(FileMesh& mesh) const {
  const Survey found = survey_of(mesh);
  const KnownFaces boundary = boundary_in(found), between = interfaces_in(found);
  std::vector<FileSurface> patches;
  auto one = faces_.lower_bound(first_side);
  for (; one != faces_.end() && boundary.hold(one->second); ++one)
    patches.push_back({one->first, name_of(one->first), one->second});
  for (; one != faces_.end(); ++one)
    if (one->first < Sheets::first_behind_sides || !between.hold(one->second)) return false;
  mesh.patches = std::move(patches);
  if (const auto border = faces_.find(border_number); border != faces_.end())
    mesh.border = border->second;
  return true;
}

void NumberedPatches::give_border(FileMesh& mesh) const {
  const auto border = faces_.find(border_number);
  if (border == faces_.end()) return;
  const auto first = faces_.lower_bound(Sheets::first_of_few);
  if (first != faces_.end()) {
    if (mesh.labels.empty()) return;
    const KnownFaces between = interfaces_in(survey_of(mesh));
    if (!std::all_of(first, faces_.end(), [&](const auto& one) { return between.hold(one.second); }))
      return;
  }
  mesh.border = border->second;
}

void NumberedPatches::give(FileMesh& mesh) {
  if (!faces_.empty() && faces_.begin()->first >= 1 &&
      !(may_have_sides(mesh) && give_all_patches(mesh)))
    give_border(mesh);
  for (auto& [number, faces] : faces_) mesh.surfaces.push_back({number, {}, std::move(faces)});
}

}  // namespace certet::formats
