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
  are_ours_ = are_ours_ && number >= 1;
  if (number == Sheets::number_of(Patch::border)) border_.push_back(face);
  if (number < Sheets::first_interface) return;
  inner_.push_back(face);
  std::ranges::sort(inner_.back());
}

std::vector<std::array<std::uint64_t, 3>> NumberedPatches::take(const FileMesh& mesh) {
  if (!are_ours_ || border_.empty() || !are_interfaces(mesh, std::move(inner_))) return {};
  return std::move(border_);
}

}  // namespace certet::formats
