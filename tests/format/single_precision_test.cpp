/// What single precision holds of a surface is decided to the last bit, and a surface that
/// it does not hold is not written.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "expect_error.hpp"
#include "files/formats/single_precision.hpp"
#include "sample_mesh.hpp"
#include "scratch_folder.hpp"

namespace certet {
namespace {

using formats::SinglePrecisionCheck;
using formats::Triangle3;

std::string loss_of(const Triangle3& triangle) {
  SinglePrecisionCheck check;
  check.add(triangle);
  return check.loss();
}

std::string loss_of(const std::vector<Point3>& points) {
  SinglePrecisionCheck check;
  check.add(points);
  return check.loss();
}

/// Singles are whole numbers there.
constexpr double whole = 1 << 23;

/// A triangle that rises by `rise` over `width`, and is level after rounding.
Triangle3 rising(double width, double rise) {
  return {{{whole, whole, whole}, {whole + 100, whole, whole},
           {whole + 50, whole + width, whole + rise}}};
}

TEST(SinglePrecision, NormalsTurnByFourDegreesAndAHalfAtMost) {
  constexpr double degrees = 3.14159265358979 / 180;
  for (const double angle : {0.0, 1.0, 4.0, 4.49}) {
    EXPECT_EQ(loss_of(rising(5, 5 * std::tan(angle * degrees))), "") << angle;
    EXPECT_EQ(loss_of(rising(5, -5 * std::tan(angle * degrees))), "") << angle;
  }
  for (const double angle : {4.51, 5.0, 5.6})
    EXPECT_EQ(loss_of(rising(5, 5 * std::tan(angle * degrees))),
              "1 of 1 triangles would be flat or turned")
        << angle;
}

TEST(SinglePrecision, AreasAreKept) {
  EXPECT_NE(loss_of(rising(0.5, 0)), "");   // to even: nothing is left
  EXPECT_EQ(loss_of(rising(0.51, 0)), "");  // to 1
  // On its back.
  EXPECT_NE(loss_of(Triangle3{{{whole + 0.6, 0, 0}, {whole + 0.4, 1, 0}, {whole + 0.55, 0.2, 0}}}),
            "");
  // What had none can lose none.
  EXPECT_EQ(loss_of(Triangle3{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}), "");
}

TEST(SinglePrecision, DistinctPointsStayDistinct) {
  const double next = std::nextafter(1.0F, 2.0F);
  const double near = std::nextafter(1.0, 2.0);
  EXPECT_EQ(loss_of({{1, 0, 0}, {next, 0, 0}, {0, 1, 0}}), "");
  EXPECT_EQ(loss_of({{1, 0, 0}, {0, 5, 0}, {near, 0, 0}, {0, 0, 0}}),
            "1 of 4 points would fall upon others");
  EXPECT_EQ(loss_of({{1, 0, 0}, {1, 0, 0}, {0, 1, 0}}), "") << "the same point twice";
  EXPECT_EQ(loss_of({{1e-60, 0, 0}, {2e-60, 0, 0}, {0, 0, 0}}),
            "2 of 3 points would fall upon others");
}

TEST(SinglePrecision, NumbersHaveAnEnd) {
  constexpr double greatest = std::numeric_limits<float>::max();
  EXPECT_EQ(loss_of({{greatest, -greatest, 0}, {0, 0, 0}}), "");
  EXPECT_EQ(loss_of({{1e39, 0, 0}, {0, -1e300, 0}, {0, 0, 0}}),
            "2 of 3 points would be beyond its numbers");
}

/// The sizes that a mesh may have.
TEST(SinglePrecision, SizesDoNotMatter) {
  for (const double size : {1e-30, 1e-9, 1.0, 1e9, 1e30}) {
    EXPECT_EQ(loss_of(Triangle3{{{size, 0, 0}, {0, size / 3, 0}, {0, 0, 0.7 * size}}}), "");
    EXPECT_NE(loss_of(Triangle3{{{size, 0, 0}, {size * (1 + 1e-9), size / 3, 0},
                                 {size * (1 + 2e-9), 2.1 * size / 3, 0}}}),
              "");
  }
}

/// A tetrahedron with edges of one, so far along x.
test::SampleMesh tetrahedron(double x) {
  test::SampleMesh mesh;
  mesh.points = {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, 1}};
  mesh.tets = {{0, 1, 2, 3}};
  return mesh;
}

TEST(SinglePrecision, OnlyStlHasIt) {
  const test::ScratchFolder folder;
  for (const char* name : {"a.vtu", "a.mesh", "a.meshb", "a.msh", "a.inp", "a.feb", "a.node",
                           "a.mfem", "a.ply"}) {
    test::write(folder / name, tetrahedron(1e9));
    if (name == std::string("a.node") || name == std::string("a.inp") ||
        name == std::string("a.feb") || name == std::string("a.mfem") || name == std::string("a.ply"))
      continue;
    EXPECT_EQ(certet::read(folder / name).points, tetrahedron(1e9).points) << name;
  }
  test::write(folder / "near.stl", tetrahedron(1e6));
  const auto names = folder.names();
  test::expect_error(ErrorCode::write_failed,
                     // The face across x keeps its place.
                     "1 of 4 points would fall upon others, 3 of 4 triangles would be flat or "
                     "turned; .ply holds it",
                     [&] { test::write(folder / "far.stl", tetrahedron(1e9)); });
  EXPECT_EQ(folder.names(), names);
}

/// In text the shortest number that reads back the same, in binary the double itself.
TEST(SinglePrecision, AllOthersHaveDoubles) {
  const test::ScratchFolder folder;
  const double number = 0.1 + 0.2;
  test::SampleMesh mesh = tetrahedron(0);
  mesh.points[3][2] = number;
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  for (const auto& [format, file] :
       {std::pair(Format::medit, "a.mesh"), {Format::gmsh22, "a.msh"}, {Format::abaqus, "a.inp"},
        {Format::febio, "a.feb"}, {Format::mfem, "a.mfem"}, {Format::tetgen, "a.node"}}) {
    test::write_as(folder / file, format, mesh);
    EXPECT_NE(test::bytes_of(folder / file).find("0.30000000000000004"), std::string::npos) << file;
  }
  for (const auto& [format, file] :
       {std::pair(Format::vtu, "a.vtu"), {Format::medit_binary, "a.meshb"},
        {Format::gmsh, "b.msh"}, {Format::ply, "a.ply"}, {Format::vtkhdf, "a.vtkhdf"},
        {Format::xdmf, "a.xdmf"}}) {
    if ((format == Format::vtkhdf || format == Format::xdmf) && !has_hdf5()) continue;
    test::write_as(folder / file, format, mesh);
    EXPECT_NE(test::bytes_of(files_of(folder / file, format).back()).find(bytes), std::string::npos) << file;
  }
}

TEST(MoveToZero, IsExactAndTold) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const double origin : {0.0, 1.0, -3.0, 1e6, -1e9, 1e300})
    for (const double size : {1e-9, 0.01, 1.0, 1e6}) {
      FileMesh mesh;
      for (int i = 0; i < 200; ++i)
        mesh.points.push_back({origin + size * unit(random), size * (unit(random) - 0.5),
                               -origin - size * unit(random)});
      const std::vector<Point3> before = mesh.points;
      const Point3 shift = move_to_zero(mesh);
      for (std::size_t i = 0; i < before.size(); ++i)
        for (std::size_t a = 0; a < 3; ++a) {
          const long double exact = static_cast<long double>(before[i][a]) - shift[a];
          ASSERT_EQ(static_cast<long double>(mesh.points[i][a]), exact);
        }
      EXPECT_EQ(shift[1], 0) << "0 is within";
      if (std::fabs(origin) > size) {
        EXPECT_LE(std::fabs(mesh.points[0][0]), 1.01 * size + 1e-9 * std::fabs(origin));
        EXPECT_NE(shift[0], 0);
      }
    }
}

}  // namespace
}  // namespace certet
