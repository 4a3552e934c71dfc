#pragma once
/// \file
/// From a mesh back to voxels: an image of labels, and how it compares with another.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "certet/context.hpp"
#include "certet/formats.hpp"
#include "certet/image.hpp"
#include "certet/mesh.hpp"

namespace certet {

/// A grid of cubes that lies around a mesh: its first voxel touches the least coordinates that
/// points of tetrahedra have, and its last one reaches at least to the greatest.
/// \throws Error `bad_option` (spacing), `bad_input` (no tetrahedra, points that are not there
/// or not finite), `too_large` (more than 2^18 voxels along an axis).
Image grid_around(const FileMesh& mesh, const Point3& spacing);

/// What became of a mesh's tetrahedra.
struct VoxelisedMesh {
  Image image;             ///< 32-bit labels; 0 where no tetrahedron is
  std::uint64_t held = 0;  ///< voxel centres in the mesh
  std::uint64_t held_twice = 0;  ///< of those, in several tetrahedra: the mesh overlaps itself
  std::uint64_t flat_tets = 0;   ///< without a volume in 2^-20 voxels; they hold no centre
  bool has_region_0 = false;     ///< which nothing tells from the outside
};

/// Gives the voxels of a grid the labels of the tetrahedra that hold their centres; a mesh
/// without labels has label 1.  The grid's own voxels are not looked at.
///
/// Points are rounded to 2^-20 voxels; from there on all is decided in whole numbers.  A centre
/// on a face, edge or corner belongs to where a step along the first axis leads or, if that stays
/// on it, along the second, or the third.  So each centre in a conforming mesh is in one
/// tetrahedron and no other, and volumes of regions side by side add up.  Where tetrahedra
/// overlap, the first has the centre.  The same for every number of threads.
/// \throws Error `bad_input` (the grid lies nowhere, or a point that a tetrahedron names is not
/// there, not finite, or 2^18 voxels away from the first), `cancelled`.
VoxelisedMesh voxelise(const FileMesh& mesh, Image grid, Context& context);
/// The same of a mesh in memory, in world coordinates.
VoxelisedMesh voxelise(const Mesh& mesh, Image grid, Context& context);

/// What is doubtful about it, a sentence each: a mesh that overlaps itself, that holds no
/// centre, or has a region 0.
std::vector<std::string> warnings_on_voxels(const VoxelisedMesh& made);

/// One label in two images of the same size.
struct LabelOverlap {
  std::int32_t label = 0;
  std::uint64_t first = 0, second = 0;  ///< voxels in each
  std::uint64_t both = 0;               ///< that have it in both
  /// Sørensen and Dice's coefficient, from 0 to 1.
  [[nodiscard]] double dice() const {
    return 2 * static_cast<double>(both) / static_cast<double>(first + second);
  }
};

/// Of all labels but 0 that one of them has, ascending.
/// \throws Error `bad_input` where the images are not the same voxels: their sizes differ, or
/// centres lie apart by more than a thousandth of a voxel; and for voxels that are no labels.
std::vector<LabelOverlap> compare_labels(const Image& first, const Image& second);

/// Whether a file's extension is one that `write_labels` knows.  \throws Error `bad_option`.
void check_labels_file(const std::filesystem::path& file);

/// Writes an image of labels by its extension: .nrrd, .mha, .nii or .nii.gz, compressed but for
/// .nii, in the narrowest of 8 bits without a sign, 16 and 32 bits.  Names of labels are not
/// kept.  What was written is read back and compared before it takes the file's name.
/// \throws Error `bad_option` (another extension), `bad_input` (voxels that are no labels, or
/// writing images was not built in), `write_failed`.
void write_labels(const Image& image, const std::filesystem::path& file);

}  // namespace certet
