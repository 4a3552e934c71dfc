/// \file
/// A mesh that several ranks make together, here threads of one process: what they write is, byte
/// for byte, the file of one, and the figures are its.

#include <gtest/gtest.h>

#include <barrier>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>
#include <tuple>
#include <vector>

#include "certet/shared_file.hpp"
#include "certet/stuffing.hpp"
#include "certet/write_mesh.hpp"
#include "domains.hpp"
#include "engine/share.hpp"
#include "materials.hpp"

namespace {

using namespace certet;
namespace fs = std::filesystem;

/// What the threads have in common.
struct Table {
  explicit Table(int count)
      : barrier(count), given(static_cast<std::size_t>(count)) {}
  std::barrier<> barrier;
  std::vector<std::vector<std::byte>> given;
};

class Thread final : public Ranks {
 public:
  Thread(Table& table, int rank) : table_(table), rank_(rank) {}
  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int count() const override { return static_cast<int>(table_.given.size()); }
  std::vector<std::vector<std::byte>> gather(std::span<const std::byte> own) override {
    table_.given[static_cast<std::size_t>(rank_)].assign(own.begin(), own.end());
    table_.barrier.arrive_and_wait();
    auto all = table_.given;
    table_.barrier.arrive_and_wait();
    return all;
  }

 private:
  Table& table_;
  int rank_;
};

/// Bytes in memory, which ranks write side by side.
class Bytes final : public SharedFile {
 public:
  Bytes(std::vector<std::byte>& bytes, Ranks& ranks) : bytes_(bytes), ranks_(ranks) {}
  void write_at(std::uint64_t offset, std::span<const std::byte> bytes) override {
    ASSERT_LE(offset + bytes.size(), bytes_.size());
    if (!bytes.empty()) std::memcpy(bytes_.data() + offset, bytes.data(), bytes.size());
  }
  void commit() override { meet(ranks_); }
  void fail(const std::string& reason) const override {
    throw Error(ErrorCode::write_failed, reason);
  }

 private:
  std::vector<std::byte>& bytes_;
  Ranks& ranks_;
};

struct Written {
  std::vector<std::byte> bytes;
  WrittenMesh mesh;
  WarpFigures figures;
  Method method{};
  std::uint64_t inverted = 0;
};

constexpr Frame frame{};

MeshSize size_of(const Stuffing& stuffing) {
  return {stuffing.point_count(), stuffing.tet_count(), !stuffing.labels().empty()};
}

/// How a mesh is asked for.
struct Asked {
  Method method;
  std::int32_t levels = 0;  ///< of grading
};

/// In slabs of a layer or two, so that shares have several.
WrittenMesh write_slabs(const Stuffing& stuffing, MeshWriter& writer, Context& context) {
  const WrittenMesh written =
      write_mesh(stuffing, frame, cut_slabs(stuffing, 100'000), writer, context);
  writer.finish();
  return written;
}

Written of_one(const Domain& domain, const Lattice& lattice, const Asked& asked) {
  Context context;
  context.threads = 1;
  Stuffing stuffing(domain, lattice, asked.method, context);
  stuffing.grade({asked.levels, {}, {}}, context);
  const fs::path file = fs::path(::testing::TempDir()) / "of_one.vtu";
  const auto writer = open_writer(file, Format::vtu, size_of(stuffing));
  Written written{{}, write_slabs(stuffing, *writer, context), stuffing.warp_figures(),
                  stuffing.method(), stuffing.inverted_tets()};
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> chars{std::istreambuf_iterator<char>(in), {}};
  const auto bytes = std::as_bytes(std::span(chars));
  written.bytes.assign(bytes.begin(), bytes.end());
  fs::remove(file);
  return written;
}

Written of_rank(const Domain& domain, const Lattice& lattice, const Asked& asked, Ranks& ranks,
                std::vector<std::byte>& bytes) {
  Context context;
  context.threads = 1;
  const auto made = [&] {
    if (asked.levels == 0) return Stuffing(domain, lattice, asked.method, ranks, context);
    Stuffing whole(domain, lattice, asked.method, context);
    whole.grade({asked.levels, {}, {}}, context);
    whole.divide(ranks);
    return whole;
  };
  const Stuffing stuffing = made();
  const MeshSize size = size_of(stuffing);
  if (ranks.rank() == 0) bytes.resize(file_bytes(Format::vtu, size));
  meet(ranks);
  const auto from = [&](auto first) { return first(stuffing.own_begin()); };
  const auto points = [&](std::int32_t k) { return stuffing.first_point(k); };
  const auto tets = [&](std::int32_t k) { return stuffing.first_tet(k); };
  const MeshPart part{from(points), points(stuffing.own_end()) - from(points), from(tets),
                      tets(stuffing.own_end()) - from(tets), ranks.rank() == 0};
  const auto writer = open_part_writer(std::make_unique<Bytes>(bytes, ranks), size, part);
  return {{}, write_slabs(stuffing, *writer, context), stuffing.warp_figures(), stuffing.method(),
          stuffing.inverted_tets()};
}

/// What rank 0 knows in the end, and the bytes.
Written of_ranks(const Domain& domain, const Lattice& lattice, const Asked& asked, int count) {
  Table table(count);
  std::vector<std::byte> bytes;
  Written first;
  {
    std::vector<std::jthread> threads;
    for (int rank = 0; rank < count; ++rank)
      threads.emplace_back([&, rank] {
        Thread ranks(table, rank);
        Written written = of_rank(domain, lattice, asked, ranks, bytes);
        if (rank == 0) first = std::move(written);
      });
  }
  first.bytes = std::move(bytes);
  return first;
}

::testing::AssertionResult same(const Written& a, const Written& b) {
  if (a.bytes != b.bytes) return ::testing::AssertionFailure() << "other bytes";
  if (a.mesh.checksum != b.mesh.checksum || a.mesh.file_checksum != b.mesh.file_checksum)
    return ::testing::AssertionFailure() << "another checksum";
  if (a.figures != b.figures || a.method != b.method || a.inverted != b.inverted)
    return ::testing::AssertionFailure() << "other figures of warping";
  if (a.mesh.lattice.histogram != b.mesh.lattice.histogram ||
      a.mesh.lattice.steps_volume != b.mesh.lattice.steps_volume ||
      a.mesh.world.volume != b.mesh.world.volume || a.mesh.rounding != b.mesh.rounding)
    return ::testing::AssertionFailure() << "another quality";
  const auto figures = [](const Region& region) {
    return std::tuple(region.label, region.tets, region.volume);
  };
  if (!std::ranges::equal(a.mesh.regions, b.mesh.regions, {}, figures, figures))
    return ::testing::AssertionFailure() << "other regions";
  return ::testing::AssertionSuccess();
}

void ranks_make_the_mesh_of_one(const Domain& domain, const Lattice& lattice, const Asked& asked) {
  const Written one = of_one(domain, lattice, asked);
  for (const int count : {1, 2, 3, 4, 7})
    EXPECT_TRUE(same(of_ranks(domain, lattice, asked, count), one))
        << name(asked.method) << ", " << asked.levels << " levels, " << count << " ranks";
}

constexpr Lattice tall{{0, 0, -40}, {9, 8, 90}};

/// Full of surface, so that every layer depends on those around it.
domains::Positional random_domain(std::uint64_t seed) {
  if (seed % 2 == 0) return domains::noise(seed, 20);
  return domains::random_cuts(seed, 20, {0, 1, 12000, 20000, 32768, 50000, 65535});
}

TEST(Shares, AreTheMeshOfOneByEachMethod) {
  for (const MethodFacts& method : methods)
    for (std::uint64_t seed = 0; seed < 4; ++seed)
      ranks_make_the_mesh_of_one(random_domain(seed), tall, {method.method});
}

TEST(Shares, OfMaterialsThatAreCutApart) {
  for (const Method method : {Method::embedded, Method::key, Method::midpoint, Method::angles})
    ranks_make_the_mesh_of_one(materials::cubes(5, 2, {1, 2, 3, 8}, 70), tall, {method});
}

TEST(Shares, OfGradedMeshes) {
  const Lattice lattice{{0, 0, 0}, {40, 40, 40}};
  const auto domain = domains::of_level(domains::sphere(40, 40, 40, 30));
  for (const Method method : {Method::embedded, Method::key, Method::midpoint})
    ranks_make_the_mesh_of_one(domain, lattice, {method, 3});
}

/// Of a shape that is small in its lattice, too: those who have nothing of it write nothing.
TEST(Shares, MayBeEmpty) {
  const auto domain = domains::of_level(domains::sphere(9, 8, 20, 6));
  ranks_make_the_mesh_of_one(domain, {{0, 0, 0}, {9, 8, 60}}, {Method::embedded});
}

TEST(Shares, AreOfEqualWork) {
  std::vector<std::uint64_t> work(100, 1);
  work[10] = 50;
  const std::vector<std::int32_t> bounds = core::balanced_bounds(work, 3);
  EXPECT_EQ(bounds, (std::vector<std::int32_t>{0, 11, 50, 100}));
  // Each has a layer, whatever it holds.
  std::vector<std::uint64_t> one_layer(5, 0);
  one_layer[4] = 7;
  EXPECT_EQ(core::balanced_bounds(one_layer, 5), (std::vector<std::int32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(core::balanced_bounds(std::vector<std::uint64_t>(5, 0), 5),
            (std::vector<std::int32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_THROW(core::balanced_bounds(one_layer, 6), Error);
}

/// What one has of a mesh does not tell of the whole.
TEST(Shares, DoNotTellOfTheWhole) {
  Table table(1);
  Thread ranks(table, 0);
  Context context;
  const auto domain = domains::of_level(domains::sphere(8, 8, 8, 5));
  Stuffing stuffing(domain, {{0, 0, 0}, {8, 8, 8}}, Method::embedded, ranks, context);
  EXPECT_THROW(static_cast<void>(stuffing.pieces({}, context)), Error);
  EXPECT_THROW(stuffing.grade({1, {}, {}}, context), Error);
  EXPECT_THROW(emit(stuffing, {}, context), Error);
}

}  // namespace
