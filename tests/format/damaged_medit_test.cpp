/// Files that a .mesh reader must refuse, each with its reason.

#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "sample_mesh.hpp"
#include "scratch_folder.hpp"

namespace certet {
namespace {

using test::expect_error;
using test::ScratchFolder;

const std::string heading = "MeshVersionFormatted 2\nDimension 3\n";
const std::string points = "Vertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";
const std::string tets = "Tetrahedra\n1\n1 2 3 4 7\n";

class DamagedMedit : public testing::Test {
 protected:
  [[nodiscard]] FileMesh read(const std::string& text) const {
    test::write_bytes(file_, text);
    return certet::read(file_);
  }
  void expect_refused(const std::string& text, const std::string& words) const {
    expect_error(ErrorCode::bad_input, words, [&] { static_cast<void>(read(text)); });
  }

  ScratchFolder folder_;
  const std::filesystem::path file_ = folder_ / "mesh.mesh";
};

TEST_F(DamagedMedit, TheSampleIsSound) {
  const FileMesh mesh = read(heading + points + tets + "End\n");
  EXPECT_EQ(mesh.points.size(), 4u);
  EXPECT_EQ(mesh.tets, (std::vector<Tet<std::uint64_t>>{{0, 1, 2, 3}}));
  EXPECT_EQ(mesh.labels, std::vector<std::int32_t>{7});
}

TEST_F(DamagedMedit, BlanksDoNotMatter) {
  EXPECT_EQ(read("MeshVersionFormatted\n2\r\nDimension\n3\r\n\n" + points + "\t" + tets + "End")
                .tets.size(),
            1u);
}

TEST_F(DamagedMedit, CutOffAnywhere) {
  const std::string whole = heading + points + tets + "End\n";
  for (std::size_t length = 0; length + 1 < whole.size(); ++length)
    expect_refused(whole.substr(0, length), file_.string());
}

TEST_F(DamagedMedit, LongFilesAreReadThroughAllTheirBuffers) {
  const test::SampleMesh mesh = test::sample_mesh(60'000, 10, false);
  test::write(file_, mesh);
  ASSERT_GT(std::filesystem::file_size(file_), 2u << 20);
  EXPECT_EQ(certet::read(file_).points, mesh.points);
  std::string bytes = test::bytes_of(file_);
  bytes.resize(bytes.size() / 2);
  expect_refused(bytes, file_.string());
}

TEST_F(DamagedMedit, AWordWithoutEnd) {
  expect_refused(heading + "Vertices\n" + std::string(3 << 20, '1'), "is not a count");
  expect_refused(std::string(3 << 20, 'M'), "not an ASCII MEDIT file");
}

TEST_F(DamagedMedit, CountsThatTheFileCannotHold) {
  expect_refused(heading + "Vertices\n1000000000000000000\n" + points, "too short for");
  expect_refused(heading + "Vertices\n99999999999999999999\n", "is not a count");
  expect_refused(heading + points + "Tetrahedra\n500\n1 2 3 4 7\nEnd\n", "too short for");
  expect_refused(heading + points + "Tetrahedra\n-1\nEnd\n", "is not a count");
  // One line more than there is, in a file long enough, reads into the next word.
  expect_refused(heading + "Vertices\n5\n" + points.substr(11) + tets + "End\n",
                 "'Tetrahedra' is not a coordinate");
  expect_refused(heading + "Vertices\n3\n" + points.substr(11) + tets + "End\n",
                 "section '0' is not known");
}

TEST_F(DamagedMedit, WrongWords) {
  expect_refused("", "not an ASCII MEDIT file");
  expect_refused("MeshVersionFormatted 9\n", "version 9");
  expect_refused("MeshVersionFormatted 2\nDimension 2\n", "dimension is not 3");
  expect_refused(heading + points + "Prisms\n1\n1 2 3 0\n" + tets + "End\n",
                 "section 'Prisms' is not known");
  expect_refused(heading + points + points + tets + "End\n", "two sections 'Vertices'");
  expect_refused(heading + points + "End\n", "no vertices or no tetrahedra");
  expect_refused(heading + points + tets, "'End' is missing");
  expect_refused(heading + points + tets + "End\n1\n", "behind its end");
  expect_refused(heading + points + "\x01\x02\n", "section '\?\?' is not known");
}

TEST_F(DamagedMedit, WrongNumbers) {
  const auto tet = [&](const std::string& line) {
    return heading + points + "Tetrahedra\n1\n" + line + "\nEnd\n";
  };
  expect_refused(tet("0 1 2 3 7"), "counted from 1");
  expect_refused(tet("-1 1 2 3 7"), "'-1' is not the number of a vertex");
  expect_refused(tet("1 2 3 4.5 7"), "'4.5' is not the number of a vertex");
  expect_refused(tet("1 2 3 4 99999999999"), "is not a reference");
  expect_refused(heading + "Vertices\n1\n0 0 1e 0\n" + tets + "End\n", "'1e' is not a coordinate");
  // An index beyond the points is the business of `check`.
  EXPECT_EQ(read(tet("1 2 3 9 7")).tets[0][3], 8u);
}

}  // namespace
}  // namespace certet
