#include "numbered_patches.hpp"

#include <algorithm>
#include <utility>

#include "sheets.hpp"

namespace certet::formats {
namespace {

/// Whether all faces, whose points are in order, lie between two labels of the mesh.
bool are_interfaces(const FileMesh& mesh, std::vector<std::array<std::uint64_t, 3>> faces) {
  if (faces.empty()) return true;
  if (mesh.labels.empty()) return false;
  Context context;
  const Survey found = survey(mesh.points.size(), std::span<const Tet<std::uint64_t>>(mesh.tets),
                              mesh.labels, context);
  std::vector<std::array<std::uint64_t, 3>> known;
  for (const Interface& interface : found.interfaces)
    for (const BoundaryFace& face : interface.faces) {
      known.push_back(face.points);
      std::ranges::sort(known.back());
    }
  std::ranges::sort(known);
  std::ranges::sort(faces);
  return std::ranges::includes(known, faces);
}

}  // namespace

void NumberedPatches::add(const std::array<std::uint64_t, 3>& face, std::int64_t number) {
  faces_[number].push_back(face);
}

void NumberedPatches::give(FileMesh& mesh) {
  const auto border = faces_.find(Sheets::number_of(Patch::border));
  if (border != faces_.end() && faces_.begin()->first >= 1) {
    Faces inner;
    for (auto sheet = faces_.lower_bound(Sheets::first_interface); sheet != faces_.end(); ++sheet)
      for (std::array<std::uint64_t, 3> face : sheet->second) {
        std::ranges::sort(face);
        inner.push_back(face);
      }
    if (are_interfaces(mesh, std::move(inner))) mesh.border = border->second;
  }
  for (auto& [number, faces] : faces_) mesh.surfaces.push_back({number, {}, std::move(faces)});
}

}  // namespace certet::formats
