/// From a shape to a file by mesh(domain) and write(mesh, path): the same bytes as the way
/// slab by slab, for every format.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "certet/certet.hpp"
#include "certet/survey.hpp"
#include "certet/write_mesh.hpp"
#include "format/scratch_folder.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

using Folder = test::ScratchFolder;

constexpr Format formats[] = {Format::vtu,    Format::vtu_zlib, Format::medit, Format::medit_binary,
                              Format::gmsh,   Format::gmsh22,   Format::abaqus, Format::febio,
                              Format::nastran, Format::dyna,   Format::mfem, Format::xdmf, Format::vtkhdf,
                              Format::tetgen, Format::polymesh, Format::stl, Format::ply};

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A ball that its bounds cut off.
auto cut_ball() {
  return BoundedFunction([](Point3 p) { return std::hypot(p[0], p[1], p[2]) - 1; },
                         Bounds{{-2, -2, -0.5}, {2, 2, 0.5}}, 0.25);
}

/// Labels 3 and 7, of which one has a name; 7 touches the image's edge.
std::unique_ptr<PlacedDomain> labelled() {
  Image image;
  image.size = {12, 10, 8};
  image.spacing = {1, 1, 1.5};
  Buffer<std::uint8_t> voxels(12 * 10 * 8);
  for (std::size_t v = 0; v < voxels.size(); ++v)
    voxels[v] = v % 12 < 2 ? 0 : v % 12 < 6 ? 3 : 7;
  image.voxels = std::move(voxels);
  image.names = {{3, "left"}, {9, "elsewhere"}};
  return label_domain(std::move(image));
}

/// Two that overlap, of which one is cut off.
std::unique_ptr<PlacedDomain> several() {
  return materials_domain({{"ball", shape_solid("sphere:1")},
                           {"slab", function_solid([](Point3 p) { return p[2]; },
                                                   Bounds{{-1.5, -0.5, -0.5}, {1.5, 0.5, 0.5}})}},
                          {.size = 0.25});
}

/// The way of a mesh that is never in memory whole.
void write_by_slabs(const PlacedDomain& domain, Method method, const fs::path& file,
                    Format format) {
  Context context;
  const Stuffing stuffing(domain, domain.lattice(), method, context);
  MeshSize size{stuffing.point_count(), stuffing.tet_count(), !stuffing.labels().empty()};
  auto found = std::make_shared<Survey>(survey(stuffing, context, domain.frame()));
  name_regions(*found, domain.names());
  if (needs_survey(format)) size.survey = found;
  const auto writer = open_writer(file, format, size);
  write_mesh(stuffing, domain.frame(), cut_slabs(stuffing, 0), *writer, context);
  writer->finish();
}

void expect_the_same_files(const PlacedDomain& domain, Method method) {
  const Folder folder;
  const Mesh made = mesh(domain, method);
  Context context;
  for (const Format format : formats) {
    if (format == Format::vtu_zlib && !can_compress()) continue;
    // Of one name, for some files say the names of those beside them.
    const char* const called = format == Format::polymesh ? "polyMesh" : "a.node";
    const fs::path ours = folder / "ours" / called, theirs = folder / "theirs" / called;
    fs::create_directories(ours.parent_path());
    fs::create_directories(theirs.parent_path());
    write(made, ours, format, context);
    write_by_slabs(domain, method, theirs, format);
    for (std::size_t f = 0; f < files_of(ours, format).size(); ++f) {
      const std::string bytes = bytes_of(files_of(ours, format)[f]);
      EXPECT_GT(bytes.size(), 100u) << name(format);
      EXPECT_EQ(bytes, bytes_of(files_of(theirs, format)[f])) << name(format);
    }
  }
}

TEST(Doorstep, FilesAreThoseOfTheWaySlabBySlab) {
  for (const MethodFacts& method : methods) {
    expect_the_same_files(cut_ball(), method.method);
    expect_the_same_files(*labelled(), method.method);
    expect_the_same_files(*several(), method.method);
  }
}

/// A comparison that could not fail would say nothing: what a mesh knows is in its files.
TEST(Doorstep, NamesBorderAndLabelsAreInTheFiles) {
  const Folder folder;
  Context context;
  for (const auto forget : {+[](Mesh& m) { m.names.clear(); }, +[](Mesh& m) { m.border.clear(); },
                            +[](Mesh& m) { m.labels = {}; }}) {
    Mesh made = mesh(*labelled());
    write(made, folder / "all.msh", context);
    forget(made);
    write(made, folder / "less.msh", context);
    EXPECT_NE(bytes_of(folder / "all.msh"), bytes_of(folder / "less.msh"));
  }
}

TEST(Doorstep, WhatWasWrittenIsReadAndWrittenAgain) {
  const Folder folder;
  const Mesh made = mesh(*labelled(), Method::midpoint);
  for (const char* file : {"a.vtu", "a.mesh", "a.meshb", "a.msh"}) {
    write(made, folder / file);
    const FileMesh back = read(folder / file);
    EXPECT_EQ(back.points.size(), made.points.size());
    EXPECT_TRUE(std::ranges::equal(back.labels, made.labels));
    EXPECT_TRUE(check(back).failures.empty());
    EXPECT_NEAR(quality(back).min_dihedral, quality(made).world.min_dihedral, 1e-9);
    const fs::path again = folder / ("again" + fs::path(file).extension().string());
    write(back, again);
    EXPECT_EQ(bytes_of(again), bytes_of(folder / file)) << file;
  }
}

TEST(Doorstep, AMeshIsCheckedAndMeasuredInMemory) {
  const Mesh made = mesh(cut_ball());
  EXPECT_TRUE(check(made).failures.empty());
  EXPECT_EQ(standing_of(quality(made), facts(made.method).bounds), Standing::within);
  const double slice = 2 * std::acos(0.0) * (1 - 0.25 / 3);  // of a ball, between -0.5 and 0.5
  EXPECT_NEAR(quality(made).world.volume, slice, 0.05 * slice);
}

TEST(Doorstep, TheMethodThatWasUsedIsTold) {
  for (const MethodFacts& method : methods) {
    const Mesh made = mesh(cut_ball(), method.method);
    EXPECT_TRUE(made.method == method.method ||
                (method.method == Method::angles && made.method == Method::embedding));
  }
}

TEST(Doorstep, ABoundedFunctionIsOutsideBeyondItsBoundsAndWhereItIsNaN) {
  const Bounds bounds{{0, 0, 0}, {1, 2, 1}};
  const BoundedFunction full([](Point3) { return -1.0; }, bounds, 0.25);
  EXPECT_NEAR(quality(mesh(full)).world.volume, 2, 0.05);
  const BoundedFunction half([](Point3 p) { return p[1] < 1 ? -1.0 : std::nan(""); }, bounds, 0.25);
  EXPECT_NEAR(quality(mesh(half)).world.volume, 1, 0.15);
}

template <class Action>
void expect_refused(ErrorCode code, const std::string& words, const Action& action) {
  try {
    action();
    ADD_FAILURE() << "nothing was refused: " << words;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(Doorstep, RefusesInOneSentence) {
  const Folder folder;
  const Mesh made = mesh(cut_ball());
  expect_refused(ErrorCode::bad_option, "known format", [&] { write(made, folder / "a.xyz"); });
  expect_refused(ErrorCode::write_failed, "a.vtu", [&] { write(made, folder / "no" / "a.vtu"); });
  expect_refused(ErrorCode::bad_input, "none.vtu", [&] { static_cast<void>(read(folder / "none.vtu")); });
  expect_refused(ErrorCode::empty_domain, "inside", [] {
    static_cast<void>(mesh(BoundedFunction([](Point3) { return 1.0; }, {{0, 0, 0}, {1, 1, 1}})));
  });
  expect_refused(ErrorCode::bad_option, "bounds", [] {
    static_cast<void>(BoundedFunction([](Point3) { return 1.0; }, {{0, 0, 0}, {1, -1, 1}}));
  });
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

/// Neither a mesh that doubles cannot hold where it lies, nor one beyond its theorem's bounds.
TEST(Doorstep, NoUnsoundMeshIsWritten) {
  const Folder folder;
  Mesh far = mesh(cut_ball());
  far.frame.origin = {1e16, 0, 0};
  expect_refused(ErrorCode::write_failed, "double precision", [&] { write(far, folder / "a.vtu"); });
  Mesh bent = mesh(cut_ball());
  bent.method = Method::midpoint;  // whose bounds it does not keep
  expect_refused(ErrorCode::check_failed, "MidpointBounds", [&] { write(bent, folder / "a.vtu"); });
  FileMesh broken{.points = {{0, 0, 0}}, .tets = {{0, 1, 2, 3}}, .labels = {}, .names = {}, .border = {}};
  expect_refused(ErrorCode::bad_input, "not there", [&] { write(broken, folder / "a.vtu"); });
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace certet
