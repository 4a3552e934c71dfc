/// Labels on their way from the domain to the mesh and to the file: asked for once,
/// and the same however the mesh is made.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <map>
#include <vector>

#include "certet/error.hpp"
#include "certet/write_mesh.hpp"
#include "domains.hpp"
#include "materials.hpp"

namespace certet {
namespace {

const std::vector<std::int32_t> some_labels{-3, 0, 40000, 7000000};
constexpr Lattice lattice{{-18, -18, -18}, {18, 18, 18}};

/// A method by which materials are not cut where they meet, so that the domain is asked.
constexpr Method uncut = Method::embedding;

constexpr std::int32_t half = 16;  ///< of the box, in lattice units

/// Cubes of materials, cut off at a box; counts the tetrahedra that it is asked for.
class Counting final : public Domain {
 public:
  explicit Counting(std::vector<std::int32_t> labels = some_labels)
      : cubes_(std::move(labels), [this](Coord3 p) {
          const std::int32_t far = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
          return far > half * steps ? 0 : uncut_.material_at(p);
        }),
        uncut_(materials::cubes(11, 5, {cubes_.labels().begin(), cubes_.labels().end()}, 100)) {}

  void row(Coord3 first, std::span<Sign> out) const override { cubes_.row(first, out); }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    cubes_.at(positions, out);
  }
  [[nodiscard]] std::span<const std::int32_t> labels() const override { return cubes_.labels(); }
  void row_materials(Coord3 first, std::span<Material> out) const override {
    cubes_.row_materials(first, out);
  }
  void materials_at(std::span<const Coord3> positions, std::span<Material> out) const override {
    cubes_.materials_at(positions, out);
  }
  void materials_of(std::span<const TetCorners> tets, std::span<Material> out) const override {
    asked_ += tets.size();
    if (throws) throw Error(ErrorCode::bad_input, "planted");
    Domain::materials_of(tets, out);
  }
  [[nodiscard]] std::span<const BorderBox> border() const override { return border_; }

  /// Since the last call.
  std::uint64_t asked() const { return asked_.exchange(0); }
  bool throws = false;

 private:
  materials::Positional cubes_, uncut_;
  mutable std::atomic<std::uint64_t> asked_{0};
  std::vector<BorderBox> border_{BorderBox::along_frame({.size = 2}, {-half, -half, -half},
                                                         {half, half, half})};
};

class Keeper final : public MeshWriter {
 public:
  void points(std::span<const Point3>) override {}
  void tets(std::span<const Tet<std::uint32_t>>, std::span<const std::int32_t> labels) override {
    labels_.insert(labels_.end(), labels.begin(), labels.end());
  }
  void tets(std::span<const Tet<std::uint64_t>>, std::span<const std::int32_t>) override {
    FAIL() << "indices fit 32 bits";
  }
  void finish() override {}
  std::vector<std::int32_t> labels_;
};

std::map<std::int32_t, std::uint64_t> counts(const auto& labels) {
  std::map<std::int32_t, std::uint64_t> result;
  for (const std::int32_t label : labels) ++result[label];
  return result;
}

std::map<std::int32_t, std::uint64_t> counts_of(const std::vector<Region>& regions) {
  std::map<std::int32_t, std::uint64_t> result;
  for (const Region& region : regions) result[region.label] = region.tets;
  return result;
}

TEST(Labels, OfTheMeshInMemoryAreTheDomains) {
  const Counting domain;
  Context context;
  const Mesh mesh = stuff(domain, lattice, {}, uncut, context);
  ASSERT_EQ(mesh.labels.size(), mesh.tet_count());
  EXPECT_EQ(domain.asked(), mesh.tet_count());
  const auto& tets = std::get<0>(mesh.tets);
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const TetCorners corners{mesh.points[tets[t][0]], mesh.points[tets[t][1]],
                             mesh.points[tets[t][2]], mesh.points[tets[t][3]]};
    Material material = 0;
    domain.materials_of({&corners, 1}, {&material, 1});
    ASSERT_GT(material, 0);
    ASSERT_EQ(mesh.labels[t], some_labels[static_cast<std::size_t>(material) - 1]);
  }
  EXPECT_EQ(counts(mesh.labels).size(), some_labels.size());
}

TEST(Labels, AreTheSameHoweverTheMeshIsWritten) {
  for (const Method method : {uncut, Method::embedded, Method::midpoint}) {
    const Counting domain;
    Context alone;
    alone.threads = 1;
    const Stuffing stuffing(domain, lattice, method, alone);
    const Mesh mesh = emit(stuffing, {}, alone);
    const std::uint64_t once = stuffing.has_interfaces() ? 0 : mesh.tet_count();
    EXPECT_EQ(once == 0, method != uncut);
    for (const int threads : {1, 3})
      for (const std::uint64_t bytes :
           {std::uint64_t{0}, std::uint64_t{300'000}, std::uint64_t{1} << 30})
        for (const bool surveyed : {false, true}) {
          Context context;
          context.threads = threads;
          domain.asked();
          Survey found;
          if (surveyed) found = survey(stuffing, context);
          Keeper keeper;
          const WrittenMesh written = write_mesh(stuffing, {}, cut_slabs(stuffing, bytes), keeper,
                                                 context, found.materials);
          EXPECT_EQ(domain.asked(), once) << "each tetrahedron once, or never";
          EXPECT_TRUE(std::ranges::equal(keeper.labels_, mesh.labels));
          EXPECT_EQ(counts_of(written.regions), counts(mesh.labels));
          if (surveyed) {
            EXPECT_EQ(counts_of(found.regions), counts(mesh.labels));
          }
          EXPECT_EQ(found.materials.empty(), !surveyed);
        }
  }
}

/// The interfaces of a mesh that is made to have them are those that are found in it.
TEST(Labels, MeetInInterfaces) {
  const Counting domain;
  Context context;
  for (const Method method : {Method::embedded, Method::midpoint}) {
    const Stuffing stuffing(domain, lattice, method, context);
    const Mesh mesh = emit(stuffing, {}, context);
    const Survey counted = survey(stuffing, context);
    const Survey found = survey(
        mesh.points.size(), std::span<const Tet<std::uint32_t>>(std::get<0>(mesh.tets)), mesh.labels, context);
    EXPECT_EQ(counted.interfaces.size(), 6u);
    EXPECT_EQ(counted.interfaces, found.interfaces);
    ASSERT_EQ(counted.boundary.size(), found.boundary.size());
    for (const Interface& interface : counted.interfaces) {
      EXPECT_LT(interface.labels[0], interface.labels[1]);
      for (const BoundaryFace& face : interface.faces)
        ASSERT_EQ(mesh.labels[face.tet], interface.labels[0]);
    }
  }
  const Stuffing stuffing(domain, lattice, uncut, context);
  EXPECT_TRUE(survey(stuffing, context).interfaces.empty());
}

/// A survey of another mesh would be noticed by the labels.
TEST(Labels, ComeFromTheSurvey) {
  const Counting domain;
  Context context;
  const Stuffing stuffing(domain, lattice, {}, context);
  Survey found = survey(stuffing, context);
  const std::int32_t layer = 7;
  std::vector<Material> spoiled(stuffing.first_tet(layer + 1) - stuffing.first_tet(layer), 2);
  found.materials.put(layer, spoiled);
  Keeper right, wrong;
  write_mesh(stuffing, {}, cut_slabs(stuffing, 0), right, context);
  write_mesh(stuffing, {}, cut_slabs(stuffing, 0), wrong, context, found.materials);
  EXPECT_NE(right.labels_, wrong.labels_);
}

TEST(Labels, AreNoneWhereTheDomainHasNone) {
  const auto solid = domains::of_level(domains::sphere(0, 0, 0, 9));
  Context context;
  const Stuffing stuffing(solid, lattice, {}, context);
  EXPECT_TRUE(emit(stuffing, {}, context).labels.empty());
  const Survey found = survey(stuffing, context);
  EXPECT_TRUE(found.materials.empty());
  Keeper keeper;
  const WrittenMesh written =
      write_mesh(stuffing, {}, cut_slabs(stuffing, 0), keeper, context, found.materials);
  EXPECT_TRUE(keeper.labels_.empty());
  const std::map<std::int32_t, std::uint64_t> all{{only_label, stuffing.tet_count()}};
  EXPECT_EQ(counts_of(written.regions), all);
  EXPECT_EQ(counts_of(found.regions), all);
}

/// One label is given without a question.
TEST(Labels, OfOneMaterialCostNothing) {
  const Counting domain({42});
  Context context;
  const Mesh mesh = stuff(domain, lattice, {}, {}, context);
  EXPECT_EQ(domain.asked(), 0u);
  EXPECT_EQ(mesh.labels.size(), mesh.tet_count());
  EXPECT_TRUE(std::ranges::all_of(mesh.labels, [](std::int32_t label) { return label == 42; }));
}

/// The border's faces are those whose points lie at the box; warped ones that have
/// moved along it, too.
TEST(Labels, TheSurveyAsksTheDomainForItsBorder) {
  for (const Method method : {Method::angles, Method::midpoint}) {
    // Where labels are cut apart, the border has points between them besides.
    const Counting domain(method == Method::angles ? some_labels : std::vector<std::int32_t>{42});
    Context context;
    const Stuffing stuffing(domain, lattice, method, context);
    const Mesh mesh = emit(stuffing, {}, context);
    EXPECT_TRUE(stuffing.has_border());
    std::size_t on_border = 0;
    const Survey found = survey(stuffing, context);
    for (const BoundaryFace& face : found.boundary) {
      const bool expected = std::ranges::all_of(face.points, [&](std::uint64_t p) {
        const Coord3 at = mesh.points[p];
        const std::int32_t far = std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)});
        return method == Method::angles ? std::abs(far - half * steps) <= 4 : stuffing.is_on_border(at);
      });
      ASSERT_EQ(face.is_cut_off, expected);
      ASSERT_EQ(face.patch >= Patch::xmin, expected);
      on_border += expected;
    }
    EXPECT_GT(on_border, 0u);
    EXPECT_LT(on_border, found.boundary.size());
  }
}

TEST(Labels, WhatTheDomainThrowsEndsTheRun) {
  Counting domain;
  Context context;
  const Stuffing stuffing(domain, lattice, uncut, context);
  domain.throws = true;
  Keeper keeper;
  EXPECT_THROW(survey(stuffing, context), Error);
  EXPECT_THROW(emit(stuffing, {}, context), Error);
  EXPECT_THROW(write_mesh(stuffing, {}, cut_slabs(stuffing, 0), keeper, context), Error);
}

/// Cancelled while materials are asked for.
TEST(Labels, CanBeCancelled) {
  struct Cancelling final : materials::Positional {
    explicit Cancelling(Context& context)
        : Positional(materials::cubes(11, 5, {1, 2}, 100)), context_(context) {}
    void materials_of(std::span<const TetCorners> tets, std::span<Material> out) const override {
      context_.cancelled = true;
      Domain::materials_of(tets, out);
    }
    Context& context_;
  };
  Context context;
  context.threads = 1;
  const Cancelling domain(context);
  const Stuffing stuffing(domain, lattice, uncut, context);
  try {
    emit(stuffing, {}, context);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::cancelled);
  }
}

}  // namespace
}  // namespace certet
