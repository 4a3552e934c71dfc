// Writes volumes with OpenVDB itself, for tests to read:
//   write_volumes <folder>
// makes ball.vdb (a level set of radius 2 around (3,4,5), voxels of 0.1), balls.vdb
// (another of 0.4 beside it), fog.vdb
// (its inside as 1, fading), several.vdb (fog twice, named thin and thick) and
// vectors.vdb.

#include <openvdb/openvdb.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/LevelSetUtil.h>

#include <string>

namespace {

void write(const std::string& file, const openvdb::GridPtrVec& grids) {
  openvdb::io::File(file).write(grids);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const std::string folder = std::string(arguments[1]) + "/";
  openvdb::initialize();
  const auto ball = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(
      2.0F, openvdb::Vec3f(3, 4, 5), 0.1F);
  ball->setName("ball");
  write(folder + "ball.vdb", {ball});
  const auto both = ball->deepCopy();
  openvdb::tools::csgUnion(*both, *openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(
                                      0.4F, openvdb::Vec3f(6, 4.3F, 5.2F), 0.1F));
  write(folder + "balls.vdb", {both});
  const auto thin = ball->deepCopy();
  openvdb::tools::sdfToFogVolume(*thin);
  thin->setName("thin");
  write(folder + "fog.vdb", {thin});
  const auto thick = thin->deepCopy();
  thick->setName("thick");
  write(folder + "several.vdb", {thin, thick});
  const auto vectors = openvdb::Vec3SGrid::create();
  vectors->setName("vectors");
  write(folder + "vectors.vdb", {vectors});
  return 0;
}
