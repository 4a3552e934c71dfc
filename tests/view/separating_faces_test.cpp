// The faces to be seen, against a search that looks at every face.
#include "view/separating_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "ball.hpp"
#include "certet/check.hpp"
#include "view/triangles.hpp"

namespace certet::view {
namespace {

using Key = std::array<std::uint64_t, 3>;

Key sorted(Key points) {
  std::ranges::sort(points);
  return points;
}

/// Face -> the tetrahedra that have it.
std::map<Key, std::vector<std::uint64_t>> all_faces(const FileMesh& mesh) {
  std::map<Key, std::vector<std::uint64_t>> faces;
  for (std::uint64_t i = 0; i < mesh.tets.size(); ++i) {
    const auto& [a, b, c, d] = mesh.tets[i];
    for (const Key& key : {Key{a, b, c}, Key{a, b, d}, Key{a, c, d}, Key{b, c, d}})
      faces[sorted(key)].push_back(i);
  }
  return faces;
}

using Found = std::map<Key, std::pair<std::uint64_t, std::uint64_t>>;

Found expected(const FileMesh& mesh, const Planes& planes) {
  Found found;
  for (const auto& [key, tets] : all_faces(mesh)) {
    const std::uint64_t other = tets.size() > 1 ? tets[1] : no_tet;
    if (other == no_tet || sides_of(mesh, tets[0], planes) != sides_of(mesh, other, planes))
      found[key] = {tets[0], other};
  }
  return found;
}

Found found(const std::vector<SeparatingFace>& faces) {
  Found found;
  for (const SeparatingFace& face : faces) found[sorted(face.points)] = {face.tet, face.other};
  return found;
}

TEST(SeparatingFaces, AreThoseOfTheSlowSearch) {
  const FileMesh mesh = ball(9);
  const Box box = box_of(mesh);
  for (const Planes& planes : {Planes(), Planes::single(1, 0.1), Planes(box.low, box.high, {3, 0, 5}),
                               Planes(box.low, box.high, {40, 40, 40})}) {
    const auto faces = separating_faces(mesh, planes);
    EXPECT_EQ(found(faces), expected(mesh, planes));
    EXPECT_EQ(found(faces).size(), faces.size());
  }
}

TEST(SeparatingFaces, AreThoseBetweenLabelsToo) {
  const FileMesh mesh = ball(9);
  std::size_t between = 0;
  for (const auto& [key, tets] : all_faces(mesh))
    if (tets.size() > 1 && mesh.labels[tets[0]] != mesh.labels[tets[1]]) ++between;
  const auto faces = separating_faces(mesh, {}, BetweenLabels::found);
  EXPECT_GT(between, 0u);
  EXPECT_EQ(faces.size(), separating_faces(mesh, {}).size() + between);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count_if(
                faces, [&](const auto& face) { return is_between_labels(mesh, face); })),
            between);
}

TEST(SeparatingFaces, AMissingTetrahedronIsNoticed) {
  FileMesh mesh = ball(9);
  const auto whole = expected(mesh, {});
  mesh.tets.erase(mesh.tets.begin() + static_cast<std::ptrdiff_t>(mesh.tets.size() / 2));
  EXPECT_NE(found(separating_faces(mesh, {})), whole);
}

TEST(SeparatingFaces, BorderIsThatOfTheCheck) {
  const FileMesh mesh = ball(9);
  const auto report = check(mesh.points, std::span<const Tet<std::uint64_t>>(mesh.tets));
  EXPECT_EQ(separating_faces(mesh, {}).size(), report.boundary_faces);
}

TEST(SeparatingFaces, TurnOutward) {
  const FileMesh mesh = ball(9);
  for (const auto& [points, tet, other] : separating_faces(mesh, {})) {
    const Point3 &a = mesh.points[points[0]], &b = mesh.points[points[1]],
                 &c = mesh.points[points[2]];
    // The ball's middle is the origin.
    const double turn = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                        a[2] * (b[0] * c[1] - b[1] * c[0]);
    EXPECT_GT(turn, 0);
  }
}

TEST(SeparatingFaces, LeaveOutTetrahedraWithoutCorners) {
  FileMesh mesh = ball(5);
  const auto before = separating_faces(mesh, {});
  mesh.tets.push_back({0, 1, 2, mesh.points.size()});
  EXPECT_EQ(found(separating_faces(mesh, {})), found(before));
}

TEST(Planes, DivideEvenly) {
  const Planes planes({0, 0, 0}, {4, 4, 4}, {3, 1, 0});
  EXPECT_EQ(planes.place(0, 0), 1);
  EXPECT_EQ(planes.place(0, 2), 3);
  EXPECT_EQ(planes.place(1, 0), 2);
  EXPECT_EQ(planes.sides({0.5, 1.9, 3}), (Planes::Sides{0, 0, 0}));
  EXPECT_EQ(planes.sides({2.5, 2.1, 3}), (Planes::Sides{2, 1, 0}));
  EXPECT_EQ(planes.sides({9, 9, 9}), (Planes::Sides{3, 1, 0}));
}

}  // namespace
}  // namespace certet::view
