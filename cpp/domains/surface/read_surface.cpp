// The only translation unit that includes assimp.

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <fstream>
#include <string>

#include "announced_counts.hpp"
#include "certet/error.hpp"
#include "certet/surface.hpp"
#include "check_text.hpp"
#include "domains/refused_file.hpp"
#include "surface_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

void check_file(const fs::path& file) {
  check_is_file(file);
  if (!std::ifstream(file)) refuse(file, "cannot be opened");
  if (fs::file_size(file) == 0) refuse(file, "is empty");
  if (!is_surface_file(file)) refuse(file, "is not an STL, OBJ, PLY or OFF file");
  check_announced_counts(file);
}

/// Assimp's own words, as part of a sentence.
std::string reason(std::string words) {
  const std::size_t end = words.find_last_not_of(" .\n\r\t");
  words.resize(end == std::string::npos ? 0 : end + 1);
  std::replace_if(words.begin(), words.end(), [](unsigned char c) { return c < ' '; }, ' ');
  return words.empty() ? "" : ": " + words;
}

/// Points and lines, which have fewer corners, are left out.
void add(const fs::path& file, const aiMesh& mesh, TriangleSurface& surface) {
  const std::size_t first = surface.points.size();
  if (first + mesh.mNumVertices > 0xffffffff) refuse(file, "has more than 2^32 points");
  for (unsigned p = 0; p < mesh.mNumVertices; ++p) {
    const aiVector3D& point = mesh.mVertices[p];
    surface.points.push_back({double{point.x}, double{point.y}, double{point.z}});
  }
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices < 3) continue;
    if (face.mNumIndices > 3) refuse(file, "has a polygon that cannot be cut into triangles");
    std::array<std::uint32_t, 3> triangle;
    for (unsigned c = 0; c < 3; ++c) {
      if (face.mIndices[c] >= mesh.mNumVertices)
        refuse(file, "has a triangle with a point that is not there");
      triangle[c] = static_cast<std::uint32_t>(first + face.mIndices[c]);
    }
    surface.triangles.push_back(triangle);
  }
}

void read_with_assimp(const fs::path& file, TriangleSurface& surface) {
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
  if (scene == nullptr) refuse(file, "cannot be read" + reason(importer.GetErrorString()));
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) add(file, *scene->mMeshes[m], surface);
}

}  // namespace

bool can_read_surfaces() { return true; }

TriangleSurface read_surface(const fs::path& file) {
  check_file(file);
  TriangleSurface surface;
  surface.name = file.string();
  const std::string extension = surface_extension(file);
  try {
    if (extension == ".ply")
      read_ply(formats::InputFile(file), surface);
    else if (extension == ".off")
      read_off(formats::InputFile(file), surface);
    else {
      if (extension == ".obj") check_obj(formats::InputFile(file));
      else if (is_text_stl(file)) check_text_stl(formats::InputFile(file));
      read_with_assimp(file, surface);
    }
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "'" + file.string() + "' needs more memory than there is");
  }
  merge_equal_points(surface);
  return surface;
}

}  // namespace certet
