/// \file
/// The pieces of each label, found while a mesh is written slab by slab, against a plain
/// count, where labels are not cut apart.

#include <gtest/gtest.h>

#include "certet/write_mesh.hpp"
#include "materials.hpp"
#include "piece_cases.hpp"

namespace {

using namespace piece_cases;

/// Takes a mesh that is only looked at.
class Nowhere final : public MeshWriter {
 public:
  void points(std::span<const Point3>) override {}
  void tets(std::span<const Tet<std::uint32_t>>, std::span<const std::int32_t>) override {}
  void tets(std::span<const Tet<std::uint64_t>>, std::span<const std::int32_t>) override {}
  void finish() override {}
};

std::vector<RegionPieces> streamed(const Stuffing& stuffing, std::uint64_t slab_bytes,
                                   int threads) {
  Context context;
  context.threads = threads;
  Nowhere nowhere;
  return write_mesh(stuffing, frame, cut_slabs(stuffing, slab_bytes), nowhere, context, {}, true)
      .region_pieces;
}

/// Cubes of one or a few lattice units, so that labels touch in every way, and tetrahedra
/// of a stencil have several.
materials::Positional random_labels(int n) {
  return materials::cubes(mixed(test_seed(), n), 1 + n % 4, {2, 5, 9},
                          n % 3 == 0 ? 0U : 60U * (static_cast<unsigned>(n) % 3));
}

TEST(RegionPieces, AreThoseOfAPlainCount) {
  std::uint64_t pieces = 0, touching = 0;
  for (int n = 0; n < 48; ++n) {
    const materials::Positional domain = random_labels(n);
    const Lattice lattice{{-6, -8, -6}, {7, 9, n % 5 == 0 ? 25 : 8}};
    Context context;
    const Stuffing stuffing(domain, lattice, n % 2 == 0 ? Method::angles : Method::embedding,
                            context);
    const std::vector<RegionPieces> expected = plain::count(emitted(stuffing)).regions;
    ASSERT_EQ(streamed(stuffing, 0, 1), expected) << n;
    ASSERT_EQ(streamed(stuffing, 100000, 2), expected) << n;
    ASSERT_EQ(streamed(stuffing, 1 << 30, 3), expected) << n;
    for (const RegionPieces& region : expected) {
      pieces += region.pieces.by_faces;
      touching += region.pieces.by_faces - region.pieces.by_vertices;
    }
  }
  EXPECT_GT(pieces, 100U);
  EXPECT_GT(touching, 10U);
}

/// Each pair that shares a face, once.
TEST(RegionPieces, FacesAreThoseThatTetrahedraShare) {
  for (int n = 0; n < 12; ++n) {
    const auto [domain, stuffing] = random_case(n);
    const plain::Mesh mesh = emitted(stuffing);
    std::vector<std::array<std::uint64_t, 2>> found;
    for (std::int32_t layer = 0; layer < stuffing.layers(); ++layer) {
      const std::uint64_t own = stuffing.first_tet(layer);
      const std::uint64_t next = stuffing.first_tet(std::min(layer + 1, stuffing.layers()));
      const auto take = [&](std::uint64_t first) {
        return [&found, own, first](std::span<const TetPair> pairs) {
          for (const auto& [a, b] : pairs)
            found.push_back({std::min(own + a, first + b), std::max(own + a, first + b)});
        };
      };
      stuffing.visit_faces_within(layer, take(own));
      stuffing.visit_faces_between(layer, take(next));
    }
    std::ranges::sort(found);
    EXPECT_EQ(found, plain::sharing_tets(mesh)) << n;
  }
}

}  // namespace
