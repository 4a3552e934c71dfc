#include "cell_faces.hpp"

#include <algorithm>
#include <compare>

#include "mesh/groups.hpp"

namespace certet::formats {
namespace {

/// A face in the group of its lowest point, and whose it is.
struct FaceOfTet {
  std::uint32_t middle = 0, highest = 0, tet = 0;
  std::uint8_t opposite = 0;

  friend auto operator<=>(const FaceOfTet&, const FaceOfTet&) = default;
  [[nodiscard]] bool same_points(const FaceOfTet& other) const {
    return middle == other.middle && highest == other.highest;
  }
};

/// Calls visit(lowest point, face) for the four faces of a tetrahedron.
template <class Visit>
void for_each_face(const Tet<std::uint32_t>& tet, std::uint32_t number, const Visit& visit) {
  for (std::uint8_t opposite = 0; opposite < 4; ++opposite) {
    std::array<std::uint32_t, 3> face{tet[(opposite + 1) % 4], tet[(opposite + 2) % 4],
                                      tet[(opposite + 3) % 4]};
    std::ranges::sort(face);
    visit(face[0], FaceOfTet{face[1], face[2], number, opposite});
  }
}

}  // namespace

CellFaces::CellFaces(std::uint64_t points, const std::vector<Tet<std::uint32_t>>& tets)
    : neighbours_(tets.size(), {none, none, none, none}), first_(tets.size() + 1, 0) {
  core::Groups<FaceOfTet> by_lowest(points);
  const auto for_all = [&](const auto& visit) {
    for (std::size_t i = 0; i < tets.size(); ++i)
      for_each_face(tets[i], static_cast<std::uint32_t>(i), visit);
  };
  for_all([&](std::uint32_t lowest, const FaceOfTet&) { by_lowest.count(lowest); });
  by_lowest.lay_out();
  for_all([&](std::uint32_t lowest, const FaceOfTet& face) { by_lowest.place(lowest, face); });
  for (std::size_t lowest = 0; lowest < by_lowest.size(); ++lowest) {
    const std::span<FaceOfTet> group = by_lowest[lowest];
    core::sort_group(group);
    const auto same = [](const FaceOfTet& a, const FaceOfTet& b) { return a.same_points(b); };
    core::for_runs(group, same, [&](std::span<FaceOfTet> run) {
      are_cells_ = are_cells_ && run.size() <= 2;
      if (run.size() != 2) return;
      neighbours_[run[0].tet][run[0].opposite] = run[1].tet;
      neighbours_[run[1].tet][run[1].opposite] = run[0].tet;
    });
  }
  for (std::size_t i = 0; i < tets.size(); ++i) {
    std::array<OwnedFace, 4> faces;
    first_[i + 1] = first_[i] + owned(static_cast<std::uint32_t>(i), faces);
  }
}

std::size_t CellFaces::owned(std::uint32_t tet, std::array<OwnedFace, 4>& faces) const {
  std::size_t count = 0;
  for (std::uint8_t opposite = 0; opposite < 4; ++opposite) {
    const std::uint32_t neighbour = neighbours_[tet][opposite];
    if (neighbour != none && neighbour > tet) faces[count++] = {neighbour, opposite};
  }
  std::sort(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(count),
            [](const OwnedFace& a, const OwnedFace& b) { return a.neighbour < b.neighbour; });
  return count;
}

std::uint64_t CellFaces::place_of(std::uint32_t tet, std::uint8_t opposite,
                                  bool& is_owner) const {
  const std::uint32_t other = neighbours_[tet][opposite];
  is_owner = tet < other;
  std::uint64_t place = 0;
  for_each_owned(std::min(tet, other), [&](const OwnedFace& face, std::uint64_t at) {
    if (face.neighbour == std::max(tet, other)) place = at;
  });
  return place;
}

}  // namespace certet::formats
