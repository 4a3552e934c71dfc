#pragma once
/// \file
/// What a graded mesh must be beside the uniform one: conforming by a count of its faces, of the
/// same volume and boundary, and of angles in the range of its theorem.

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "certet/stuffing.hpp"
#include "exact.hpp"

namespace graded {

using certet::Coord3;
using certet::Method;

using Triangle = std::array<Coord3, 3>;

/// Of some material; 0 where there is but one.
struct PlacedTet {
  std::array<Coord3, 4> corners;
  std::int32_t label = 0;
  friend bool operator==(const PlacedTet&, const PlacedTet&) = default;
};

struct PlacedMesh {
  std::vector<Coord3> points;
  std::vector<PlacedTet> tets;
};

inline PlacedMesh placed(const certet::Stuffing& stuffing) {
  certet::Context context;
  context.threads = 2;
  const certet::Mesh mesh = certet::emit(stuffing, {}, context);
  PlacedMesh placed;
  placed.points.assign(mesh.points.begin(), mesh.points.end());
  std::visit(
      [&](const auto& tets) {
        for (std::size_t t = 0; t < tets.size(); ++t) {
          const auto& [a, b, c, d] = tets[t];
          placed.tets.push_back({{mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]},
                                 mesh.labels.empty() ? 0 : mesh.labels[t]});
        }
      },
      mesh.tets);
  return placed;
}

/// The same vertices the same way round, starting from the least.
inline Triangle turned(Triangle face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

inline Triangle other_side(const Triangle& face) { return turned({face[0], face[2], face[1]}); }

/// The faces of tetrahedra by who is on their inner side.
using Faces = std::map<Triangle, std::int32_t>;

/// Which faces have no tetrahedron of the same label behind them: the surface and the interfaces.
/// `twice` says whether two tetrahedra are on one side of a face.
inline Faces single_faces(const PlacedMesh& mesh, bool& twice) {
  Faces faces;
  for (const auto& [corners, label] : mesh.tets) {
    const auto& [a, b, c, d] = corners;
    for (const Triangle& face : {Triangle{b, c, d}, {a, d, c}, {a, b, d}, {a, c, b}})
      twice = twice || !faces.emplace(turned(face), label).second;
  }
  Faces single;
  for (const auto& [face, label] : faces) {
    const auto behind = faces.find(other_side(face));
    if (behind == faces.end() || behind->second != label) single.emplace(face, label);
  }
  return single;
}

inline exact::Wide six_volume(const PlacedMesh& mesh) {
  exact::Wide sum = 0;
  for (const PlacedTet& tet : mesh.tets) sum += exact::six_volume(tet.corners);
  return sum;
}

inline std::map<std::int32_t, exact::Wide> volumes(const PlacedMesh& mesh) {
  std::map<std::int32_t, exact::Wide> sums;
  for (const PlacedTet& tet : mesh.tets) sums[tet.label] += exact::six_volume(tet.corners);
  return sums;
}

/// The first property that a graded mesh breaks, in words; empty if it has them all.
inline std::string fault(const PlacedMesh& graded, const PlacedMesh& uniform,
                  const exact::AngleRange& range) {
  std::set<Coord3> used;
  for (const PlacedTet& tet : graded.tets) used.insert(tet.corners.begin(), tet.corners.end());
  const std::set<Coord3> points(graded.points.begin(), graded.points.end());
  if (points.size() != graded.points.size()) return "two points are at one place";
  if (points != used) return "a point is not used";
  for (const PlacedTet& tet : graded.tets) {
    if (exact::six_volume(tet.corners) <= 0) return "a tetrahedron is not positive";
    for (const exact::Dihedral& angle : exact::dihedrals(tet.corners))
      if (!range.contains(angle))
        return "an angle of " + std::to_string(static_cast<double>(angle.degrees())) + " degrees";
  }
  bool twice = false;
  const Faces single = single_faces(graded, twice);
  if (twice) return "two tetrahedra are on one side of a face";
  if (single != single_faces(uniform, twice)) return "the boundary is another one";
  if (six_volume(graded) != six_volume(uniform)) return "the volume is another one";
  return "";
}

inline const exact::AngleRange& range_of(Method method) {
  static const exact::AngleRange midpoint(29.9999, 135.0001);  // both are attained
  if (method == Method::midpoint) return midpoint;
  if (method == Method::key) return exact::key_range;
  return method == Method::embedding ? exact::embedding_range : exact::angles_range;
}

/// The length of the longest edge, in long edges of the lattice.
inline double longest_edge(const PlacedTet& tet) {
  double longest = 0;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const Coord3 d = tet.corners[a] - tet.corners[b];
      longest = std::max(longest, std::hypot(d.x, d.y, d.z) / (2 * certet::steps));
    }
  return longest;
}

}  // namespace graded
