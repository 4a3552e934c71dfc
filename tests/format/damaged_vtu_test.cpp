/// Files that a .vtu reader must refuse, each with its reason.

#include <gtest/gtest.h>

#include <cstring>

#include "expect_error.hpp"
#include "sample_mesh.hpp"
#include "scratch_folder.hpp"

namespace certet {
namespace {

using test::expect_error;
using test::sample_mesh;
using test::SampleMesh;
using test::ScratchFolder;

class DamagedVtu : public testing::Test {
 protected:
  DamagedVtu() {
    test::write(file_, mesh_);
    bytes_ = test::bytes_of(file_);
  }

  void expect_refused(const std::string& bytes, const std::string& words) const {
    test::write_bytes(file_, bytes);
    expect_error(ErrorCode::bad_input, words, [this] { certet::read(file_); });
  }

  [[nodiscard]] std::string replaced(const std::string& old, const std::string& by) const {
    std::string changed = bytes_;
    const std::size_t at = changed.find(old);
    EXPECT_NE(at, changed.npos) << old;
    return changed.replace(at, old.size(), by);
  }

  [[nodiscard]] std::string with_number(const std::string& attribute, const std::string& old,
                                        const std::string& by) const {
    return replaced(attribute + "=\"" + old + "\"", attribute + "=\"" + by + "\"");
  }

  /// Where the appended data begins.
  [[nodiscard]] std::size_t data() const { return bytes_.find("\n_") + 2; }

  ScratchFolder folder_;
  const std::filesystem::path file_ = folder_ / "mesh.vtu";
  const SampleMesh mesh_ = sample_mesh(9, 7, true);
  std::string bytes_;
};

TEST_F(DamagedVtu, CutOffAnywhere) {
  // Without its last line feed the file is still whole.
  for (std::size_t length = 0; length + 1 < bytes_.size(); ++length)
    expect_refused(bytes_.substr(0, length), file_.string());
}

TEST_F(DamagedVtu, BytesLostInTheMiddle) {
  for (std::size_t at = data(); at < bytes_.size() - 40; at += 5) {
    std::string shorter = bytes_;
    shorter.erase(at, 8);
    expect_refused(shorter, file_.string());
  }
}

TEST_F(DamagedVtu, AnyChangedByteIsSurvived) {
  for (std::size_t at = 0; at < bytes_.size(); ++at)
    for (const char change : {'\0', '"', '9', '\xff'}) {
      std::string changed = bytes_;
      changed[at] = change;
      test::write_bytes(file_, changed);
      try {
        const FileMesh mesh = certet::read(file_);
        EXPECT_EQ(mesh.tets.size(), mesh_.tets.size());
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_input);
      }
    }
}

TEST_F(DamagedVtu, CountsThatTheFileCannotHold) {
  for (const char* count : {"8", "10", "0", "99999999", "768614336404564651", "1152921504606846976",
                            "18446744073709551615"}) {
    expect_refused(with_number("NumberOfPoints", "9", count), "does not agree");
    expect_refused(with_number("NumberOfCells", "7", count), "does not agree");
  }
  for (const char* count : {"", "-9", "9x", "18446744073709551616"})
    expect_refused(with_number("NumberOfPoints", "9", count), "NumberOfPoints is no number");
}

TEST_F(DamagedVtu, OffsetsThatTheFileDoesNotHave) {
  for (const char* offset : {"100000", "9223372036854775807", "18446744073709551615"})
    expect_refused(replaced("offset=\"0\"", std::string("offset=\"") + offset + "\""),
                   "beyond its end");
}

TEST_F(DamagedVtu, SizesThatTheFileDoesNotHave) {
  for (const std::uint64_t size : {std::uint64_t{0}, std::uint64_t{215}, std::uint64_t{217},
                                   std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
    std::string changed = bytes_;
    std::memcpy(changed.data() + data(), &size, sizeof size);
    expect_refused(changed, "array Points/Points");
  }
}

TEST_F(DamagedVtu, OtherKindsOfFiles) {
  expect_refused("", "damaged");
  expect_refused("solid cube\n", "damaged");
  expect_refused("<html></html>", "not a VTK XML file");
  expect_refused(replaced("type=\"UnstructuredGrid\"", "type=\"PolyData\""),
                 "not an unstructured grid");
  expect_refused(replaced("LittleEndian", "BigEndian"), "byte order");
  expect_refused(replaced("UInt64", "UInt16"), "header type");
  expect_refused(replaced("header_type", "compressor=\"vtkLZ4DataCompressor\" header_type"),
                 "another method");
  expect_refused(replaced("header_type", "compressor=\"vtkZLibDataCompressor\" header_type"),
                 "array Points/Points");
  expect_refused(replaced("encoding=\"raw\"", "encoding=\"hex\""), "neither raw nor base64");
  expect_refused(replaced("encoding=\"raw\"", "encoding=\"base64\""), "array Points/Points");
  expect_refused(replaced("format=\"appended\"", "format=\"ascii\""), "is not a number");
  expect_refused(replaced("Float64", "Float32"), "does not agree");
  expect_refused(replaced("Float64", "String "), "of type String");
  expect_refused(replaced("\"connectivity\"", "\"connections\""), "no array Cells/connectivity");
  expect_refused(replaced("NumberOfComponents=\"3\"", "NumberOfComponents=\"2\""),
                 "does not agree");
  expect_refused(replaced("    </Piece>", "    </Piece><Piece>"), "several pieces");
  expect_refused(replaced("\n_", "\n"), "underscore");
}

TEST_F(DamagedVtu, OtherCells) {
  // The array of types is the one but last, before the labels.
  const std::size_t types = data() + 8 + 9 * 24 + 8 + 7 * 16 + 8 + 7 * 4 + 8;
  ASSERT_EQ(bytes_[types], 10);
  std::string changed = bytes_;
  changed[types + 6] = 12;
  expect_refused(changed, "other than tetrahedra");
  changed = bytes_;
  const std::size_t offsets = types - 8 - 7 * 4;
  ASSERT_EQ(bytes_[offsets], 4);
  changed[offsets] = 3;
  expect_refused(changed, "offsets are not those of tetrahedra");
}

TEST_F(DamagedVtu, NegativeIndicesBecomePointsThatAreNotThere) {
  std::string changed = bytes_;
  const std::int32_t negative = -1;
  std::memcpy(changed.data() + data() + 8 + 9 * 24 + 8, &negative, sizeof negative);
  test::write_bytes(file_, changed);
  EXPECT_EQ(certet::read(file_).tets[0][0], ~std::uint64_t{0});
}

TEST_F(DamagedVtu, IndicesOf64BitsAreRead) {
  const std::size_t tets = data() + 8 + 9 * 24;
  std::string wide(8 + 7 * 4 * 8, '\0');
  const std::uint64_t size = wide.size() - 8;
  std::memcpy(wide.data(), &size, sizeof size);
  const auto indices = mesh_.wide_tets();
  std::memcpy(wide.data() + 8, indices.data(), size);
  // The wide array goes to the end of the data, where it moves nothing.
  const std::size_t end = bytes_.rfind("\n  </AppendedData>");
  std::string changed = bytes_;
  changed.insert(end, wide);
  const std::string old = "type=\"Int32\" Name=\"connectivity\" format=\"appended\" offset=\"" +
                          std::to_string(tets - data()) + "\"";
  const std::size_t at = changed.find(old);
  ASSERT_NE(at, changed.npos);
  changed.replace(at, old.size(),
                  "type=\"Int64\" Name=\"connectivity\" format=\"appended\" offset=\"" +
                      std::to_string(end - data()) + "\"");
  test::write_bytes(file_, changed);
  EXPECT_EQ(certet::read(file_).tets, indices);
}

TEST(MissingInput, HasItsReason) {
  const ScratchFolder folder;
  expect_error(ErrorCode::bad_input, "No such file", [&] { certet::read(folder / "a.vtu"); });
  std::filesystem::create_directory(folder / "b.mesh");
  expect_error(ErrorCode::bad_input, "it is a folder", [&] { certet::read(folder / "b.mesh"); });
  std::filesystem::create_symlink("/dev/zero", folder / "c.vtu");
  expect_error(ErrorCode::bad_input, "regular file", [&] { certet::read(folder / "c.vtu"); });
}

}  // namespace
}  // namespace certet
