/// Writing a counted mesh: what is reported of the file's coordinates.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "certet/error.hpp"
#include "certet/write_mesh.hpp"
#include "domains.hpp"

namespace certet {
namespace {

/// Keeps what it is given.
class Keeper final : public MeshWriter {
 public:
  void points(std::span<const Point3> points) override {
    points_.insert(points_.end(), points.begin(), points.end());
  }
  void tets(std::span<const Tet<std::uint32_t>> tets, std::span<const std::int32_t>) override {
    tets_.insert(tets_.end(), tets.begin(), tets.end());
  }
  void tets(std::span<const Tet<std::uint64_t>>, std::span<const std::int32_t>) override {
    FAIL() << "indices fit 32 bits";
  }
  void finish() override {}

  [[nodiscard]] std::uint64_t checksum() const {
    FileMesh mesh;
    mesh.points = points_;
    for (const auto& [a, b, c, d] : tets_) mesh.tets.push_back({a, b, c, d});
    return certet::checksum(mesh);
  }
  [[nodiscard]] std::uint64_t coincident() const { return count_coincident(points_); }
  [[nodiscard]] Quality measured() const {
    return measure_world(points_, 0, std::span<const Tet<std::uint32_t>>(tets_),
                         Histogram::empty);
  }

 private:
  std::vector<Point3> points_;
  std::vector<Tet<std::uint32_t>> tets_;
};

/// A turned frame whose origin is `distance` long edges away along each axis.
Frame far_frame(double distance) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  Frame frame{.axes = {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}}, .size = 0.37};
  frame.origin.fill(distance * frame.size);
  return frame;
}

struct Outcome {
  Quality told, measured;
  double rounding;
  WrittenMesh written;
  std::uint64_t checksum, coincident;
};

Outcome write(const Frame& frame, Method method = Method::angles, std::uint64_t slab_bytes = 0) {
  const auto domain = domains::of_level([](double x, double y, double z) {
    return std::sin(3.1 * x + 1.7 * y) + std::sin(2.3 * y - 4.1 * z) + std::sin(5.3 * z + x);
  });
  Context context;
  const Stuffing stuffing(domain, {{-16, -16, -16}, {16, 16, 16}}, method, context);
  Keeper keeper;
  const WrittenMesh written =
      write_mesh(stuffing, frame, cut_slabs(stuffing, slab_bytes), keeper, context);
  return {written.world, keeper.measured(),  frame.rounding(16),
          written,       keeper.checksum(), keeper.coincident()};
}

TEST(WrittenMesh, NearTheOriginTheWorldHasTheAnglesOfTheLattice) {
  for (const double distance : {0.0, 1.0, 1e3, 8e4}) {
    const auto [told, measured, rounding, written, checksum, coincident] = write(far_frame(distance));
    EXPECT_LE(rounding, 1e-11);
    EXPECT_NEAR(told.min_dihedral, measured.min_dihedral, 1e-6);
    EXPECT_NEAR(told.max_dihedral, measured.max_dihedral, 1e-6);
    EXPECT_NEAR(told.volume, measured.volume, 1e-6 * measured.volume);
    EXPECT_EQ(told.nonpositive, measured.nonpositive);
    EXPECT_EQ(told.tets, measured.tets);
  }
}

TEST(WrittenMesh, FarFromTheOriginAnglesAreMeasured) {
  for (const double distance : {1e6, 1e9, 1e12}) {
    const auto [told, measured, rounding, written, checksum, coincident] = write(far_frame(distance));
    EXPECT_GT(rounding, 1e-11);
    EXPECT_EQ(told.min_dihedral, measured.min_dihedral);
    EXPECT_EQ(told.max_dihedral, measured.max_dihedral);
    EXPECT_EQ(told.nonpositive, measured.nonpositive);
  }
  // The error that would be overlooked otherwise.
  const auto [told, measured, rounding, written, checksum, coincident] = write(far_frame(1e12));
  EXPECT_GT(std::fabs(told.min_dihedral - write(far_frame(0)).told.min_dihedral), 1e-4);
}

TEST(WrittenMesh, AFrameThatIsNoRotationIsMeasured) {
  Frame sheared = far_frame(0);
  sheared.axes[0][1] += 0.3;
  const auto [told, measured, rounding, written, checksum, coincident] = write(sheared);
  EXPECT_EQ(told.min_dihedral, measured.min_dihedral);
  EXPECT_GT(std::fabs(told.min_dihedral - write(far_frame(0)).told.min_dihedral), 1e-2);
}

/// Bound and truth: what rounding did to the extreme angles, and what it may have done.
TEST(WrittenMesh, RoundingTurnsNoAngleByMoreThanIsTold) {
  for (const Method method : {Method::angles, Method::midpoint})
    for (const double distance : {0.0, 1e5, 1e7, 1e9, 1e11}) {
      const WrittenMesh written = write(far_frame(distance), method).written;
      const double moved =
          std::max(std::fabs(written.world.min_dihedral - written.lattice.min_dihedral),
                   std::fabs(written.world.max_dihedral - written.lattice.max_dihedral));
      EXPECT_LE(moved, written.rounding + 1e-9) << distance;
      // It is a bound, but no idle one.
      EXPECT_LE(written.rounding, 1e-4 + 1e3 * moved) << distance;
    }
}

/// The bounds of the midpoint method are attained, so that rounding alone crosses them.
TEST(WrittenMesh, RoundingAloneIsNoFault) {
  const AngleBounds& bounds = facts(Method::midpoint).bounds;
  const auto at = [](double distance) {
    return write(far_frame(distance), Method::midpoint).written;
  };
  for (const double distance : {0.0, 1e6, 1e8}) {
    const WrittenMesh written = at(distance);
    EXPECT_EQ(standing_of(written, bounds), Standing::within) << distance;
    EXPECT_EQ(written.coincident_points, 0u);
  }
  EXPECT_LT(at(1e8).world.min_dihedral, bounds.min_dihedral - 1e-6);
  // Here the doubles are too far apart, and lastly points fall together.
  for (const double distance : {1e12, 1e14, 1e16})
    EXPECT_EQ(standing_of(at(distance), bounds), Standing::blurred) << distance;
  const Outcome lost = write(far_frame(1e16), Method::midpoint);
  EXPECT_GT(lost.coincident, 0u);
  EXPECT_GT(lost.written.coincident_points, 0u);
}

TEST(WrittenMesh, SizesAndTurnsDoNotMatter) {
  const AngleBounds& bounds = facts(Method::midpoint).bounds;
  for (const double size : {1e-30, 1e-9, 1.0, 1e9, 1e30})
    for (const double distance : {0.0, 1e8}) {
      Frame frame = far_frame(distance);
      for (double& coordinate : frame.origin) coordinate *= size / frame.size;
      frame.size = size;
      EXPECT_EQ(standing_of(write(frame, Method::midpoint).written, bounds), Standing::within) << size;
    }
}

/// A mesh that is somewhere else than the frame says is no victim of rounding.
TEST(WrittenMesh, AFaultIsNotExcusedByRounding) {
  const AngleBounds& bounds = facts(Method::midpoint).bounds;
  WrittenMesh written = write(far_frame(1e8), Method::midpoint).written;
  written.world.min_dihedral = bounds.min_dihedral - 2 * written.rounding - 0.001;
  EXPECT_EQ(standing_of(written, bounds), Standing::outside);
  written = write(far_frame(0), Method::midpoint).written;
  written.lattice.max_dihedral = bounds.max_dihedral + 1e-7;
  EXPECT_EQ(standing_of(written, bounds), Standing::outside);
  written = write(far_frame(0), Method::midpoint).written;
  written.world.nonpositive = 1;
  EXPECT_EQ(standing_of(written, bounds), Standing::outside);
  written = write(far_frame(0), Method::midpoint).written;
  written.coincident_points = 1;
  EXPECT_EQ(standing_of(written, bounds), Standing::blurred);
}

TEST(WrittenMesh, TheChecksumOfTheFileIsThatOfWhatWasWritten) {
  const Outcome whole = write(far_frame(3), Method::angles, 1 << 30);
  EXPECT_EQ(whole.written.file_checksum, whole.checksum);
  EXPECT_EQ(write(far_frame(3)).written.file_checksum, whole.checksum);
  const Outcome elsewhere = write(far_frame(4));
  EXPECT_EQ(elsewhere.written.checksum, whole.written.checksum);
  EXPECT_NE(elsewhere.written.file_checksum, whole.written.file_checksum);
}

/// The bound itself: no point is farther from its exact place.
TEST(Frame, RoundingIsBounded) {
  for (const double distance : {0.0, 3.0, 1e6}) {
    const Frame frame = far_frame(distance);
    const double bound = frame.rounding(1000) * frame.size;
    for (std::int32_t n = -1000; n <= 1000; n += 7) {
      const Coord3 position{n * steps + 12345, -n * steps + 777, n * steps - 1};
      const Point3 world = frame.world(position);
      for (std::size_t r = 0; r < 3; ++r) {
        const long double unit = static_cast<long double>(frame.size) / (2.0L * steps);
        const long double exact =
            frame.origin[r] + unit * (frame.axes[r][0] * static_cast<long double>(position.x) +
                                      frame.axes[r][1] * static_cast<long double>(position.y) +
                                      frame.axes[r][2] * static_cast<long double>(position.z));
        EXPECT_LE(std::fabs(static_cast<double>(world[r] - exact)), bound);
      }
    }
  }
}

/// Refused before anything is written.
TEST(WrittenMesh, ASizeBeyondTheLimitsIsRefused) {
  for (const double size : {0.99 * least_size, 1.01 * greatest_size, 5e-324}) {
    Frame frame;
    frame.size = size;
    try {
      write(frame);
      ADD_FAILURE() << size;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::too_large);
    }
  }
}

}  // namespace
}  // namespace certet
