/// What is written is read back, and the bytes do not tell how it was written.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "expect_error.hpp"
#include "sample_mesh.hpp"
#include "scratch_folder.hpp"

namespace certet {
namespace {

using test::bytes_of;
using test::sample_mesh;
using test::SampleMesh;
using test::ScratchFolder;

class RoundTrip : public testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& name = "mesh") const {
    return folder_ / (name + GetParam());
  }
  ScratchFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip, testing::Values(".vtu", ".mesh", ".meshb", ".msh"),
                         [](const auto& info) { return std::string(info.param).substr(1); });

void expect_same(const FileMesh& read, const SampleMesh& written) {
  ASSERT_EQ(read.points.size(), written.points.size());
  for (std::size_t i = 0; i < read.points.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double a = read.points[i][axis], b = written.points[i][axis];
      ASSERT_TRUE(a == b && std::signbit(a) == std::signbit(b)) << i << ": " << a << " " << b;
    }
  ASSERT_EQ(read.tets, written.wide_tets());
  if (read.labels != written.labels) {
    // Formats in which every tetrahedron has some label.
    ASSERT_TRUE(written.labels.empty());
    ASSERT_EQ(read.labels, std::vector<std::int32_t>(read.tets.size(), only_label));
  }
}

TEST_P(RoundTrip, ReadsWhatWasWritten) {
  for (const bool labels : {false, true})
    for (const bool wide : {false, true}) {
      SampleMesh mesh = sample_mesh(3000, 10'000, labels);
      // Gmsh's groups are positive.
      if (format_of(file()) == Format::gmsh)
        for (std::int32_t& label : mesh.labels) label += 10;
      test::write(file(), mesh, 1 << 30, wide);
      expect_same(certet::read(file()), mesh);
    }
}

TEST_P(RoundTrip, ExtremeDoubles) {
  SampleMesh mesh = sample_mesh(4, 1, false);
  using Limits = std::numeric_limits<double>;
  mesh.points = {{Limits::max(), Limits::lowest(), Limits::min()},
                 {Limits::denorm_min(), -Limits::denorm_min(), Limits::epsilon()},
                 {0.1, 1.0 / 3, -1e22},
                 {9007199254740993.0, 5e-324, -0.0}};
  test::write(file(), mesh);
  expect_same(certet::read(file()), mesh);
}

TEST_P(RoundTrip, PiecesGiveTheBytesOfTheWhole) {
  // More than a megabyte, so that gathered pieces go to the file now and then.
  const SampleMesh mesh = sample_mesh(60'000, 90'000, true);
  test::write(file("whole"), mesh);
  const std::string whole = bytes_of(file("whole"));
  for (const std::size_t piece : {std::size_t{1}, std::size_t{977}, std::size_t{50'000}})
    for (const bool wide : {false, true}) {
      test::write(file("pieces"), mesh, piece, wide);
      EXPECT_TRUE(bytes_of(file("pieces")) == whole) << piece << (wide ? " wide" : "");
    }
}

TEST_P(RoundTrip, EmptyMesh) {
  const auto writer =
      open_writer(file(), *format_of(file()), {0, 0, false, std::make_shared<Survey>()});
  writer->points({});
  writer->tets(std::span<const Tet<std::uint32_t>>(), {});
  writer->finish();
  const FileMesh mesh = certet::read(file());
  EXPECT_TRUE(mesh.points.empty());
  EXPECT_TRUE(mesh.tets.empty());
}

TEST_P(RoundTrip, SizeIsKnownBefore) {
  for (const bool labels : {false, true}) {
    const SampleMesh mesh = sample_mesh(5000, 20'000, labels);
    test::write(file(), mesh);
    const auto bytes = static_cast<double>(std::filesystem::file_size(file()));
    const auto expected = static_cast<double>(file_bytes(*format_of(file()), mesh.size()));
    if (*format_of(file()) != Format::medit)
      EXPECT_EQ(bytes, expected);
    else
      EXPECT_NEAR(bytes, expected, 0.3 * bytes);
  }
}

/// Interfaces too, however many: a label for each cube.
TEST(Formats, SizeWithInterfacesIsKnownBefore) {
  const ScratchFolder folder;
  const auto label_of = [](auto i, auto j, auto k) { return static_cast<int>((k * 8 + j) * 8 + i) + 1; };
  const SampleMesh mesh = test::cubes(8, label_of);
  const MeshSize size = mesh.size();
  ASSERT_EQ(size.survey->regions.size(), 512u);
  ASSERT_GE(size.survey->interfaces.size(), 3u * 7 * 8 * 8);
  for (const auto& [format, name] :
       {std::pair(Format::vtu, "a.vtu"), std::pair(Format::medit, "a.mesh"),
        std::pair(Format::medit_binary, "a.meshb"), std::pair(Format::gmsh, "a.msh"),
        std::pair(Format::gmsh22, "b.msh"), std::pair(Format::abaqus, "a.inp"),
        std::pair(Format::febio, "a.feb"), std::pair(Format::nastran, "a.bdf"),
        std::pair(Format::dyna, "a.k"), std::pair(Format::mfem, "a.mfem"),
        std::pair(Format::xdmf, "a.xdmf"), std::pair(Format::vtkhdf, "a.vtkhdf"), std::pair(Format::tetgen, "a.node"),
        std::pair(Format::vtp, "a.vtp"), std::pair(Format::stl, "a.stl"),
        std::pair(Format::ply, "a.ply")}) {
    if ((format == Format::vtkhdf || format == Format::xdmf) && !has_hdf5()) continue;
    test::write_as(folder / name, format, mesh);
    double bytes = 0;
    for (const auto& file : files_of(folder / name, format))
      bytes += static_cast<double>(std::filesystem::file_size(file));
    const auto expected = static_cast<double>(file_bytes(format, size));
    const bool exact = format == Format::vtu || format == Format::medit_binary ||
                       format == Format::gmsh || format == Format::stl;
    EXPECT_NEAR(bytes, expected, exact ? 0 : 0.12 * bytes) << name;
    // That it goes by the interfaces: without them it is another.
    if (format == Format::vtu || format == Format::vtkhdf || format == Format::stl || format == Format::ply) continue;
    MeshSize without = size;
    auto survey = std::make_shared<Survey>(*size.survey);
    survey->interfaces.clear();
    without.survey = survey;
    EXPECT_GT(std::abs(static_cast<double>(file_bytes(format, without)) - bytes), 0.2 * bytes) << name;
  }
}

TEST_P(RoundTrip, NothingIsLeftBesideTheFile) {
  test::write(file(), sample_mesh(10, 10, false));
  EXPECT_EQ(folder_.names(), std::vector<std::string>{file().filename().string()});
}

/// Of formats that are not chosen by an extension.
TEST(Formats, AreReadWhateverTheirVariant) {
  const ScratchFolder folder;
  const SampleMesh mesh = sample_mesh(3000, 10'000, true);
  for (const auto& [format, name] : {std::pair(Format::vtu_zlib, "a.vtu"),
                                     std::pair(Format::gmsh22, "a.msh")}) {
    if (format == Format::vtu_zlib && !can_compress()) continue;
    test::write_as(folder / name, format, mesh);
    const FileMesh read = certet::read(folder / name);
    EXPECT_EQ(read.points, mesh.points);
    EXPECT_EQ(read.tets, mesh.wide_tets());
    if (format == Format::vtu_zlib) {
      EXPECT_EQ(read.labels, mesh.labels);
    }
  }
}

TEST(Formats, AreKnownByTheirExtension) {
  EXPECT_EQ(format_of("a.vtu"), Format::vtu);
  EXPECT_EQ(format_of("folder.mesh/a.b.MESH"), Format::medit);
  for (const char* name : {"a", "a.vtk", ".vtu", "a.vtu.gz", "vtu", ""})
    EXPECT_FALSE(format_of(name)) << name;
  test::expect_error(ErrorCode::bad_input, ".vtu, .mesh, .meshb, .msh", [] { certet::read("a.stl"); });
}

TEST(Formats, IndicesGrowTo64BitsWhereTheyMust) {
  constexpr std::uint64_t limit = std::uint64_t{1} << 31;
  const auto bytes = [](std::uint64_t points, std::uint64_t tets) {
    return file_bytes(Format::vtu, {points, tets, false, nullptr});
  };
  // One more point takes 24 bytes; beyond 2^31 - 1 all indices take 4 more.
  EXPECT_EQ(bytes(limit - 1, 1000) - bytes(limit - 2, 1000), 24u);
  EXPECT_EQ(bytes(limit, 1000) - bytes(limit - 1, 1000), 24u + 4 * 4 * 1000);
  // One more tetrahedron takes 4 indices, an offset and a type.
  EXPECT_EQ(bytes(9, limit / 4 - 1) - bytes(9, limit / 4 - 2), 21u);
  EXPECT_GT(bytes(9, limit / 4) - bytes(9, limit / 4 - 1), limit);
}

}  // namespace
}  // namespace certet
