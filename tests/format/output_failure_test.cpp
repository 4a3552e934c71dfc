/// Output that cannot be written: one sentence, and no trace in the folder.

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "expect_error.hpp"
#include "sample_mesh.hpp"
#include "scratch_folder.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;
using test::expect_error;
using test::sample_mesh;
using test::SampleMesh;
using test::ScratchFolder;

class FailingOutput : public testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] std::string name() const { return std::string("mesh") + GetParam(); }
  [[nodiscard]] fs::path file() const { return folder_ / name(); }
  ScratchFolder folder_;
  // Such that single precision, which .stl has, holds it.
  const SampleMesh mesh_ = sample_mesh(100, 200, false, 1, 0);
};

INSTANTIATE_TEST_SUITE_P(Formats, FailingOutput, testing::Values(".vtu", ".mesh", ".meshb", ".msh", ".inp", ".feb",
                                                            ".bdf", ".k", ".mfem",
                                                            ".vtp", ".stl", ".ply"),
                         [](const auto& info) { return std::string(info.param).substr(1); });

/// The file has the bytes that writing the mesh gives elsewhere.
void expect_holds(const fs::path& file, const SampleMesh& mesh) {
  const ScratchFolder elsewhere;
  const fs::path other = elsewhere / file.filename().string();
  test::write(other, mesh);
  EXPECT_TRUE(test::bytes_of(file) == test::bytes_of(other)) << file;
}

void expect_write_failed(const std::string& words, const fs::path& file,
                         const SampleMesh& mesh) {
  expect_error(ErrorCode::write_failed, words, [&] { test::write(file, mesh); });
  expect_error(ErrorCode::write_failed, file.string(), [&] { test::write(file, mesh); });
}

TEST_P(FailingOutput, AFolderIsNoTarget) {
  fs::create_directory(file());
  expect_write_failed("it is a folder", file(), mesh_);
  EXPECT_EQ(folder_.names().size(), 1u);
}

TEST_P(FailingOutput, TheFolderMustBeThere) {
  expect_write_failed("No such file", folder_ / "missing" / name(), mesh_);
  EXPECT_TRUE(folder_.names().empty());
}

TEST_P(FailingOutput, ADeviceIsNotReplaced) {
  fs::create_symlink("/dev/null", file());
  expect_write_failed("not a regular file", file(), mesh_);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(fs::is_symlink(file()));
}

TEST_P(FailingOutput, AReadOnlyFileOrFolderIsRespected) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  test::write_bytes(file(), "precious");
  fs::permissions(file(), fs::perms::owner_read);
  expect_write_failed("Permission denied", file(), mesh_);
  EXPECT_EQ(test::bytes_of(file()), "precious");
  fs::remove(file());
  fs::permissions(folder_.path(), fs::perms::owner_read | fs::perms::owner_exec);
  expect_write_failed("Permission denied", file(), mesh_);
  fs::permissions(folder_.path(), fs::perms::owner_all);
}

TEST_P(FailingOutput, AnAbandonedWriterLeavesTheOldFile) {
  test::write_bytes(file(), "precious");
  {
    const auto writer = open_writer(file(), *format_of(file()), mesh_.size());
    test::write_points(*writer, mesh_.points, 10);
    EXPECT_EQ(folder_.names().size(), 2u);
  }
  EXPECT_EQ(folder_.names().size(), 1u);
  EXPECT_EQ(test::bytes_of(file()), "precious");
}

TEST_P(FailingOutput, TheOldFileIsReplacedAtTheEnd) {
  test::write_bytes(file(), "old");
  const auto writer = open_writer(file(), *format_of(file()), mesh_.size());
  test::write_points(*writer, mesh_.points, 10);
  test::write_tets(*writer, mesh_.tets, mesh_.labels, 10);
  EXPECT_EQ(test::bytes_of(file()), "old");
  writer->finish();
  expect_holds(file(), mesh_);
}

TEST_P(FailingOutput, ASymbolicLinkIsFollowed) {
  fs::create_directory(folder_ / "real");
  const fs::path real = folder_ / "real" / name();
  test::write_bytes(real, "old");
  fs::create_symlink(real, file());
  test::write(file(), mesh_);
  EXPECT_TRUE(fs::is_symlink(file()));
  expect_holds(real, mesh_);
}

TEST_P(FailingOutput, TwoWritersOfOneFileDoNotMeet) {
  const SampleMesh other = sample_mesh(50, 70, false, 2, 0);
  const auto first = open_writer(file(), *format_of(file()), mesh_.size());
  const auto second = open_writer(file(), *format_of(file()), other.size());
  test::write_points(*first, mesh_.points, 7);
  test::write_points(*second, other.points, 7);
  test::write_tets(*first, mesh_.tets, mesh_.labels, 7);
  test::write_tets(*second, other.tets, other.labels, 7);
  second->finish();
  expect_holds(file(), other);
  first->finish();
  expect_holds(file(), mesh_);
}

TEST_P(FailingOutput, TheFileIsReadableAsTheUserWants) {
  const mode_t mask = ::umask(027);
  test::write(file(), mesh_);
  ::umask(mask);
  EXPECT_EQ(static_cast<unsigned>(fs::status(file()).permissions()), 0640u);
}

TEST_P(FailingOutput, WhatIsWrittenMustBeWhatWasAnnounced) {
  const auto attempt = [&](const std::string& words, const MeshSize& size, auto action) {
    expect_error(ErrorCode::write_failed, words, [&] {
      const auto writer = open_writer(file(), *format_of(file()), size);
      action(*writer);
    });
    EXPECT_TRUE(folder_.names().empty());
  };
  const std::span<const Tet<std::uint32_t>> tets(mesh_.tets);
  attempt("fewer", mesh_.size(), [&](MeshWriter& writer) { writer.finish(); });
  attempt("fewer", mesh_.size(), [&](MeshWriter& writer) {
    writer.points(mesh_.points);
    writer.tets(tets.first(199), {});
    writer.finish();
  });
  const auto announced = [&](std::uint64_t points, std::uint64_t count, bool labels) {
    MeshSize size = mesh_.size();
    size.points = points;
    size.tets = count;
    size.labels = labels;
    return size;
  };
  const bool surface_alone = name() == "mesh.stl" || name() == "mesh.ply" || name() == "mesh.vtp";
  attempt(surface_alone ? "not there" : "more points", announced(99, 200, false),
          [&](MeshWriter& writer) { writer.points(mesh_.points); });
  attempt("more tetrahedra", announced(100, 199, false), [&](MeshWriter& writer) {
    writer.points(mesh_.points);
    writer.tets(tets, {});
  });
  attempt("before all points", mesh_.size(), [&](MeshWriter& writer) {
    writer.points(std::span(mesh_.points).first(99));
    writer.tets(tets, {});
  });
  attempt("labels", announced(100, 200, true), [&](MeshWriter& writer) {
    writer.points(mesh_.points);
    writer.tets(tets, {});
  });
  attempt("not there", announced(100, 1, false), [&](MeshWriter& writer) {
    writer.points(mesh_.points);
    const Tet<std::uint64_t> tet{1, 2, 3, (std::uint64_t{1} << 32) + 4};
    writer.tets(std::span(&tet, 1), {});
  });
}

/// Limits the size of files, without the signal that goes with it.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST_P(FailingOutput, AFileThatMayNotGrow) {
  const FileSizeLimit limit(4096);
  expect_write_failed("File too large", file(), mesh_);
  EXPECT_TRUE(folder_.names().empty());
}

/// A file system of 64 KiB, if the test may mount one.
class TinyDisk {
 public:
  explicit TinyDisk(const fs::path& folder)
      : folder_(folder),
        mounted_(::mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=64k") == 0) {}
  ~TinyDisk() {
    if (mounted_) ::umount(folder_.c_str());
  }
  [[nodiscard]] bool mounted() const { return mounted_; }

 private:
  fs::path folder_;
  bool mounted_;
};

TEST_P(FailingOutput, AFullDisk) {
  fs::create_directory(folder_ / "disk");
  const TinyDisk disk(folder_ / "disk");
  if (!disk.mounted()) GTEST_SKIP() << "no right to mount a small disk";
  const SampleMesh large = sample_mesh(60'000, 90'000, false);
  const fs::path file = folder_ / "disk" / name();
  expect_write_failed("No space left", file, large);
  EXPECT_TRUE(fs::is_empty(folder_ / "disk"));
  test::write(file, mesh_);
  expect_holds(file, mesh_);
}

TEST(FailingTetgen, LeavesNoneOfItsThreeFiles) {
  const ScratchFolder folder;
  const SampleMesh mesh = sample_mesh(100, 200, true);
  for (const char* name : {"mesh.node", "mesh.ele", "mesh.face"}) {
    test::write_bytes(folder / "mesh.ele", "precious");
    fs::remove(folder / name);
    fs::create_directory(folder / name);
    expect_error(ErrorCode::write_failed, name, [&] { test::write(folder / "mesh.ele", mesh); });
    EXPECT_EQ(folder.names().size(), std::string(name) == "mesh.ele" ? 1u : 2u);
    fs::remove_all(folder / name);
    fs::remove(folder / "mesh.ele");
  }
  {
    const FileSizeLimit limit(4096);
    expect_error(ErrorCode::write_failed, "File too large",
                 [&] { test::write(folder / "mesh.node", mesh); });
    EXPECT_TRUE(folder.names().empty());
  }
  test::write(folder / "mesh.face", mesh);
  EXPECT_EQ(folder.names().size(), 3u);
}

TEST(FailingSurvey, IsMissedOrWrong) {
  const ScratchFolder folder;
  const SampleMesh mesh = sample_mesh(100, 200, true);
  for (const char* name : {"a.msh", "a.inp", "a.feb", "a.bdf", "a.k", "a.mfem"}) {
    MeshSize size = mesh.size();
    size.survey = nullptr;
    expect_error(ErrorCode::write_failed, "survey",
                 [&] { open_writer(folder / name, *format_of(name), size); });
    const std::string ending = fs::path(name).extension();
    if (ending == ".bdf" || ending == ".k" || ending == ".mfem") continue;  // not by regions
    Survey survey = *mesh.size().survey;
    survey.regions.back().tets -= 1;
    size.survey = std::make_shared<Survey>(survey);
    expect_error(ErrorCode::write_failed, "region", [&] {
      const auto writer = open_writer(folder / name, *format_of(name), size);
      writer->points(mesh.points);
      writer->tets(std::span<const Tet<std::uint32_t>>(mesh.tets), mesh.labels);
    });
    EXPECT_TRUE(folder.names().empty());
  }
}

}  // namespace
}  // namespace certet
