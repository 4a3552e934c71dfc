/// Labels keep their numbers and names through every format, or it is said.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include "../seed.hpp"
#include "sample_mesh.hpp"
#include "scratch_folder.hpp"

namespace certet {
namespace {

using test::bytes_of;
using test::ScratchFolder;

using Labels = std::vector<std::int32_t>;

struct Case {
  FileMesh mesh;
  bool all_positive = true;
};

/// Few or many, near 0 or anywhere.
std::int32_t random_label(std::mt19937_64& random) {
  constexpr std::int32_t extremes[] = {0, 1, -1, INT32_MAX, INT32_MAX - 1, INT32_MIN, 255, -32768};
  switch (between(random, 0, 3)) {
    case 0: return extremes[between(random, 0, 7)];
    case 1: return between(random, INT32_MIN, INT32_MAX);
    default: return between(random, -3, 12);
  }
}

/// Printable, without what Gmsh has no room for, and different where case does not matter.
std::string random_name(std::mt19937_64& random, std::int32_t label) {
  constexpr std::string_view letters = "abc XY(/&<>'$-_.19\xc3\xa4";
  std::string name = std::to_string(label) + ":";
  for (int i = between(random, 1, 20); i > 0; --i)
    if (const char c = letters[static_cast<std::size_t>(between(random, 0, 18))];
        static_cast<unsigned char>(c) < 0x80)
      name += c;
    else
      name += "\xc3\xa4";
  return name;
}

Case random_case(std::mt19937_64& random, bool positive) {
  std::set<std::int32_t> chosen;
  for (int n = between(random, 1, 9); n > 0; --n)
    if (const std::int32_t label = random_label(random); label > 0 || !positive)
      chosen.insert(label);
  if (chosen.empty()) chosen.insert(1);
  const Labels labels(chosen.begin(), chosen.end());
  Case made;
  made.all_positive = labels.front() > 0;
  const test::SampleMesh sample = test::sample_mesh(300, 200, false, random(), 5);
  made.mesh.points = sample.points;
  made.mesh.tets = sample.wide_tets();
  for (std::size_t i = 0; i < made.mesh.tets.size(); ++i)
    made.mesh.labels.push_back(
        labels[i < labels.size() ? i : static_cast<std::size_t>(between(
                                           random, 0, static_cast<int>(labels.size()) - 1))]);
  for (const std::int32_t label : labels)
    if (between(random, 0, 2) > 0) made.mesh.names[label] = random_name(random, label);
  return made;
}

struct Variant {
  Format format;
  const char* file;
  bool names;
};

std::vector<Variant> readable() {
  std::vector<Variant> all{{Format::vtu, "a.vtu", false},
                           {Format::medit, "a.mesh", false},
                           {Format::medit_binary, "a.meshb", false},
                           {Format::gmsh, "a.msh", true},
                           {Format::gmsh22, "a.msh", true}};
  if (can_compress()) all.push_back({Format::vtu_zlib, "a.vtu", false});
  return all;
}

constexpr int cases = 60;

TEST(LabelsInFiles, ComeBackThroughEveryFormat) {
  const ScratchFolder folder;
  Context context;
  for (int n = 0; n < cases; ++n) {
    std::mt19937_64 random(mixed(test_seed(), n));
    Case made = random_case(random, n % 3 == 0);
    FileMesh mesh = made.mesh;
    std::vector<Variant> way = readable();
    std::ranges::shuffle(way, random);
    for (const auto& [format, file, names] : way) {
      const auto losses = write(mesh, folder / file, format, context);
      const bool gmsh = format == Format::gmsh || format == Format::gmsh22;
      EXPECT_EQ(losses.empty(), !gmsh || made.all_positive) << name(format);
      FileMesh read = certet::read(folder / file);
      ASSERT_EQ(read.labels, made.mesh.labels) << name(format) << ", case " << n;
      EXPECT_EQ(read.names, names ? made.mesh.names : LabelNames()) << name(format);
      mesh = std::move(read);
      mesh.names = made.mesh.names;
    }
  }
}

/// What another program sees: for each label the physical group of its tetrahedra.
std::map<std::int32_t, std::int32_t> groups_in(const std::string& text, const Labels& labels) {
  std::istringstream words(text.substr(text.find("$Elements")));
  std::string word;
  std::size_t count = 0, tet = 0;
  words >> word >> count;
  std::map<std::int32_t, std::int32_t> groups;
  for (std::size_t i = 0; i < count; ++i) {
    std::int64_t number = 0, point = 0;
    int type = 0, tags = 0;
    std::int32_t physical = 0, entity = 0;
    words >> number >> type >> tags >> physical >> entity;
    for (int c = type == 4 ? 4 : 3; c > 0; --c) words >> point;
    if (type != 4) continue;
    EXPECT_EQ(physical, entity);
    EXPECT_EQ(groups.emplace(labels[tet], physical).first->second, physical);
    ++tet;
  }
  return groups;
}

TEST(LabelsInFiles, PositiveOnesAreTheNumbersOfGroups) {
  const ScratchFolder folder;
  Context context;
  for (int n = 0; n < cases; ++n) {
    std::mt19937_64 random(mixed(test_seed(), n, 1));
    const FileMesh mesh = random_case(random, false).mesh;
    const auto losses = write(mesh, folder / "a.msh", Format::gmsh22, context);
    std::set<std::int32_t> taken;
    for (const auto& [label, group] : groups_in(bytes_of(folder / "a.msh"), mesh.labels)) {
      EXPECT_GT(group, 0);
      EXPECT_TRUE(taken.insert(group).second) << "two labels are group " << group;
      if (label > 0) {
        EXPECT_EQ(group, label);
        continue;
      }
      ASSERT_EQ(losses.size(), 1u);
      EXPECT_NE(losses[0].find("label " + std::to_string(label) + " has the number " +
                               std::to_string(group)),
                std::string::npos)
          << losses[0];
    }
  }
}

FileMesh two_tets(Labels labels) {
  FileMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  mesh.tets = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  mesh.labels = std::move(labels);
  return mesh;
}

TEST(LabelsInFiles, TheNextFreeNumberIsBehindTheGreatest) {
  const ScratchFolder folder;
  Context context;
  EXPECT_NE(write(two_tets({0, 3}), folder / "a.msh", Format::gmsh, context).at(0).find(
                "label 0 has the number 4;"), std::string::npos);
  EXPECT_NE(write(two_tets({-7, INT32_MAX}), folder / "a.msh", Format::gmsh, context).at(0).find(
                "label -7 has the number 1;"), std::string::npos);
}

TEST(LabelsInFiles, FormatsThatAreOnlyWrittenHaveThemToo) {
  const ScratchFolder folder;
  Context context;
  const FileMesh mesh = two_tets({0, -5});
  for (const auto& [format, file] : {std::pair(Format::tetgen, "a.node"),
                                     std::pair(Format::abaqus, "a.inp"),
                                     std::pair(Format::febio, "a.feb")})
    EXPECT_TRUE(write(mesh, folder / file, format, context).empty());
  EXPECT_EQ(bytes_of(folder / "a.ele"), "2 4 1\n1 1 2 3 4 0\n2 2 3 4 5 -5\n");
  for (const char* file : {"a.inp", "a.feb"}) {
    const std::string text = bytes_of(folder / file);
    EXPECT_NE(text.find("region_0"), std::string::npos) << file;
    EXPECT_NE(text.find("region_minus_5"), std::string::npos) << file;
  }
}

/// Files of others: tetrahedra in no group are not in the one that has their entity's number.
TEST(LabelsInFiles, EntitiesAreNotTakenForGroups) {
  const ScratchFolder folder;
  const std::string nodes = "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n";
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + nodes + "$Elements\n2\n";
  test::write_bytes(folder / "a.msh", head + "1 4 2 5 1 1 2 3 4\n2 4 2 0 5 2 4 3 5\n$EndElements\n");
  EXPECT_EQ(certet::read(folder / "a.msh").labels, (Labels{5, 0}));
  test::write_bytes(folder / "b.msh", head + "1 4 2 0 1 1 2 3 4\n2 4 2 0 5 2 4 3 5\n$EndElements\n");
  EXPECT_EQ(certet::read(folder / "b.msh").labels, (Labels{1, 5}));
  const std::string box = " 0 0 0 1 1 1 ";
  test::write_bytes(folder / "c.msh",
                    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 2\n1" + box +
                        "1 5 0\n5" + box + "0 0\n$EndEntities\n$Nodes\n1 5 1 5\n3 1 0 5\n1\n2\n3\n"
                        "4\n5\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n$EndNodes\n$Elements\n2 2 1 2\n"
                        "3 1 4 1\n1 1 2 3 4\n3 5 4 1\n2 2 4 3 5\n$EndElements\n");
  EXPECT_EQ(certet::read(folder / "c.msh").labels, (Labels{5, 0}));
}

}  // namespace
}  // namespace certet
