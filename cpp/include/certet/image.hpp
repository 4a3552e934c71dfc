#pragma once
/// \file
/// Three-dimensional images as domains: solids of labels, and solids bounded by
/// a level of a grayscale image.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "certet/buffer.hpp"
#include "certet/placed_domain.hpp"

namespace certet {

/// Voxel values in the type that the file has; the first axis runs fastest.
using Voxels =
    std::variant<Buffer<std::uint8_t>, Buffer<std::int8_t>, Buffer<std::uint16_t>,
                 Buffer<std::int16_t>, Buffer<std::uint32_t>, Buffer<std::int32_t>,
                 Buffer<float>, Buffer<double>>;

/// A voxel grid and where it lies.  The centre of voxel (i,j,k) is
///     origin + axes * (spacing[0] i, spacing[1] j, spacing[2] k)
/// in world coordinates: ITK's physical space, LPS (x to the patient's left, y
/// to the back, z to the head), for NIfTI too.
struct Image {
  std::string name;  ///< what sentences call it: the file
  std::array<std::int64_t, 3> size{0, 0, 0};
  Point3 spacing{1, 1, 1};
  Point3 origin{0, 0, 0};
  /// Row major; column a is the direction of voxel axis a.  Orthonormal, but
  /// right-handed or left-handed.
  std::array<std::array<double, 3>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Voxels voxels;
  std::vector<std::string> notes = {};  ///< what is doubtful about it, a sentence each

  /// Whether the voxels are whole numbers, which makes them labels.
  [[nodiscard]] bool integral() const { return voxels.index() < 6; }
};

/// Whether `read_image` was built in.
bool can_read_images();

/// What a file may leave open.
struct ImageChoice {
  std::string series;             ///< UID of a DICOM series; empty: the only one there is
  std::optional<Point3> spacing;  ///< in the place of the file's own
};

/// Reads an image of three dimensions and one number per voxel: a NIfTI, NRRD,
/// MetaImage or TIFF file, or a folder that holds a DICOM series.  The header is
/// judged before memory is taken for the voxels.
///
/// The slices of a DICOM series are put in the order of their positions, whatever
/// their names and numbers; the third axis is the normal of the slices.  The pages
/// of a TIFF file are slices from z = 0 upwards, the centre of the first voxel is
/// the world's origin, and the first axis runs along the rows.
/// \throws Error `bad_input` where the file is missing, truncated, not such an
/// image, or has a direction that is not orthonormal, and where the slices of a
/// series are not equally spaced; `bad_option` where a folder holds several series
/// or not the one chosen; `too_large` where the voxels need more than `max_bytes`.
/// The sentence names the file.
Image read_image(const std::filesystem::path& file, std::uint64_t max_bytes,
                 const ImageChoice& choice = {});

/// Labels first, first + 1, …, last.
struct LabelRange {
  std::int64_t first, last;
};

/// How finely an image is meshed.
struct ImageLattice {
  double size = 0;  ///< long edge in world units; 0: the smallest voxel spacing
  std::int32_t margin = 2;  ///< lattice cells around the solid, at least 1
};

/// A solid in an image, whose voxels it shares with other solids of the same image,
/// on lattices of other sizes too.  Where `size` is the voxel spacing, the lattice lies so
/// that each voxel holds one even and one odd point, a quarter of its diagonal
/// before and behind its centre.  Beyond the outermost voxels all is outside,
/// which closes the solid at the image's border.
///
/// The frame is right-handed for every image.  The longest side is that of the
/// box of voxels that the solid lies in; a level's solid may reach into the voxels
/// next to those above the level.  The bytes are those of the image's voxels too.
class ImageDomain : public PlacedDomain {
 public:
  /// The labels of tetrahedra of this domain's mesh, corners in steps: that of
  /// the voxel nearest to the centroid or, where that one was not chosen, of the
  /// chosen voxel at the corner nearest to it.  0 for a level's solid.
  virtual void label(std::span<const std::array<Coord3, 4>> tets,
                     std::span<std::int32_t> out) const = 0;
};

/// The union of all voxels with one of the labels; without labels, of all that
/// are not 0.  The sign of a point is that of the voxel it lies in.
/// \throws Error `bad_option` (size, margin), `bad_input` (voxels that are not
/// whole numbers, or chosen labels beyond 32 bits), `empty_domain`, `too_large`.
std::unique_ptr<ImageDomain> label_domain(std::shared_ptr<const Image> image,
                                          std::vector<LabelRange> labels,
                                          const ImageLattice& lattice);

/// Where the image, interpolated trilinearly between voxel centres (and held
/// constant over the outer half of the outermost voxels), is above `level`.
/// \throws Error `bad_option`, `bad_input` (voxels that are NaN or infinite),
/// `empty_domain`, `too_large`.
std::unique_ptr<ImageDomain> level_domain(std::shared_ptr<const Image> image, double level,
                                          const ImageLattice& lattice);

/// The same of an image that nobody else needs.
inline std::unique_ptr<ImageDomain> label_domain(Image image, std::vector<LabelRange> labels,
                                                 const ImageLattice& lattice) {
  return label_domain(std::make_shared<const Image>(std::move(image)), std::move(labels),
                      lattice);
}
inline std::unique_ptr<ImageDomain> level_domain(Image image, double level,
                                                 const ImageLattice& lattice) {
  return level_domain(std::make_shared<const Image>(std::move(image)), level, lattice);
}

}  // namespace certet
