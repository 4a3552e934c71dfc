// Writes small volumes with OpenVDB itself, one of each kind of grid, packing, transform
// and layout of a file that it has:
//   write_small_volumes <folder>

#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>

#include <fstream>
#include <string>

namespace {

using openvdb::io::COMPRESS_ACTIVE_MASK;
using openvdb::io::COMPRESS_BLOSC;
using openvdb::io::COMPRESS_NONE;
using openvdb::io::COMPRESS_ZIP;

void write(const std::string& file, const openvdb::GridPtrVec& grids,
           std::uint32_t compression = COMPRESS_BLOSC | COMPRESS_ACTIVE_MASK) {
  openvdb::io::File archive(file);
  archive.setCompression(compression);
  archive.write(grids);
}

/// Where the file says not where its grids begin.
void write_stream(const std::string& file, const openvdb::GridPtrVec& grids) {
  std::ofstream stream(file, std::ios::binary);
  openvdb::io::Stream(stream).write(grids);
}

/// A level set in one leaf or a few.
template <class Grid>
typename Grid::Ptr ball() {
  const auto grid = openvdb::tools::createLevelSetSphere<Grid>(1.5F, openvdb::Vec3f(3.5F, 3.5F, 3.5F), 1.0F, 2.0F);
  grid->setName("ball");
  return grid;
}

/// Values of no class and several backgrounds, and a tile.
template <class Grid>
typename Grid::Ptr fog(const std::string& name) {
  using Value = typename Grid::ValueType;
  const auto grid = Grid::create(Value(0));
  for (int n = 0; n < 8; ++n)
    grid->tree().setValue(openvdb::Coord(1 + n % 3, 2 + n % 2, 1 + n / 3), Value(n) / 4);
  grid->tree().setValueOff(openvdb::Coord(5, 5, 5), Value(7));
  grid->tree().addTile(1, openvdb::Coord(8, 0, 0), Value(1), true);
  grid->setName(name);
  return grid;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const std::string folder = std::string(arguments[1]) + "/";
  openvdb::initialize();
  write(folder + "ball.vdb", {ball<openvdb::FloatGrid>()});
  write(folder + "double.vdb", {ball<openvdb::DoubleGrid>()});
  const auto half = ball<openvdb::FloatGrid>();
  half->setSaveFloatAsHalf(true);
  write(folder + "half.vdb", {half});
  const auto thick = fog<openvdb::FloatGrid>("thick");
  write(folder + "zip.vdb", {thick}, COMPRESS_ZIP | COMPRESS_ACTIVE_MASK);
  write(folder + "plain.vdb", {thick}, COMPRESS_ACTIVE_MASK);
  write(folder + "named.vdb", {fog<openvdb::FloatGrid>("thin"), thick, thick->copyGrid()});
  write_stream(folder + "stream.vdb", {thick, fog<openvdb::DoubleGrid>("thin")});
  const auto skew = fog<openvdb::FloatGrid>("thick");
  skew->setTransform(openvdb::math::Transform::createLinearTransform(
      openvdb::Mat4d(1., .5, 0., 0., 0., 2., 0., 0., 0., 0., 1., 0., 3., 4., 5., 1.)));
  skew->insertMeta("place", openvdb::Vec3DMetadata({1, 2, 3}));
  skew->insertMeta("checked", openvdb::BoolMetadata(true));
  write(folder + "skew.vdb", {skew});
  const auto frustum = fog<openvdb::FloatGrid>("thick");
  frustum->setTransform(openvdb::math::Transform::createFrustumTransform(
      openvdb::BBoxd({0, 0, 0}, {10, 10, 10}), 0.5, 3, 1));
  const auto vectors = openvdb::Vec3SGrid::create();
  vectors->setName("vectors");
  write(folder + "others.vdb", {frustum, vectors, openvdb::BoolGrid::create()});
  return 0;
}
