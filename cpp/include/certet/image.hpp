#pragma once
/// \file
/// Three-dimensional images as domains: solids of labels, and solids bounded by
/// a level of a grayscale image.

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "certet/bounds.hpp"
#include "certet/buffer.hpp"
#include "certet/context.hpp"
#include "certet/placed_domain.hpp"
#include "certet/labels.hpp"
#include "certet/pieces.hpp"

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
  Voxels voxels = {};
  LabelNames names = {};  ///< of labels, where the file tells some
  std::vector<std::string> notes = {};  ///< what is doubtful about it, a sentence each

  /// Whether the voxels are whole numbers, which makes them labels.
  [[nodiscard]] bool integral() const { return voxels.index() < 6; }
};

/// An image of the same name in the same place, without the voxels.
Image place_of(const Image& image);

/// Whether `read_image` was built in.
bool can_read_images();

/// What a file may leave open.
struct ImageChoice {
  std::string series;             ///< UID of a DICOM series; empty: the only one there is
  std::optional<Point3> spacing;  ///< in the place of the file's own
  /// Of several volumes in a file, or numbers per voxel, from 0.
  std::optional<std::uint64_t> volume = {};
};

/// Reads an image of three dimensions and one number per voxel: a NIfTI, NRRD,
/// MetaImage or TIFF file, a folder that holds a DICOM series, or a DICOM file of
/// several frames.  The header is checked before memory is taken for the voxels.
///
/// Values are what the file means and not what it stores: slope and intercept of
/// NIfTI and DICOM are applied.  Segmentations whose segments may overlap (3D Slicer's
/// .seg.nrrd, DICOM SEG) become labels, a note says which segment was taken where.
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
Image read_image(const std::filesystem::path& file,
                 std::uint64_t max_bytes = std::numeric_limits<std::uint64_t>::max(),
                 const ImageChoice& choice = {});

/// The image with labels for voxels: as it is where they are whole numbers already,
/// else made from floating point ones, which must all be whole.  NaN becomes `nan`
/// where that is given.
/// \throws Error `bad_input` that says how many voxels are no labels, why, and where the
/// first is.
Image with_labels(Image image, std::optional<std::int32_t> nan = {});

/// Puts a value in the place of all that are NaN.  \returns how many there were.
std::uint64_t replace_nan(Image& image, double value);

/// Whether whole numbers look like shades of gray rather than labels: there are more
/// than 50, and those that are neither 0 nor the commonest come in short runs along the
/// first axis, of less than 2.5 voxels on average; of less than 5 where there are more
/// than 1000.
bool looks_grayscale(const Image& image);

/// Labels first, first + 1, …, last.
struct LabelRange {
  std::int64_t first, last;
};

/// How finely an image is meshed.
struct ImageLattice {
  double size = 0;  ///< long edge in world units; 0: the smallest voxel spacing
  std::int32_t margin = 2;  ///< lattice cells around the solid, at least 1
  /// Of labels: whether the walls of voxels are halfway between even and odd points.  For
  /// methods that settle they had better not be, and that keeps more of the volume; with cuts in
  /// the middle of edges the solid would be shifted, by 3/16 of a voxel.
  bool walls_halfway = true;
};

// Solids in images share their voxels with other solids of the same image, on
// lattices of other sizes too.  Where `size` is the voxel spacing, each voxel holds one
// even and one odd point, half its diagonal apart.  They are a
// quarter of the diagonal before and behind its centre or, of labels whose walls are not to
// be halfway, 7/16 before and 1/16 behind, so that just one of the two is near to a wall:
// if both move onto walls, tetrahedra at the edges of the solid lose all their corners to
// them, and it its edges.  Beyond the outermost voxels all is outside,
// which closes the solid at the image's border: the domain is cut off there.
//
// The frame is right-handed for every image.  The longest side is that of the
// box of voxels that the solid lies in; a level's solid may reach into the voxels
// next to those above the level.  The bytes are those of the image's voxels too.

/// The union of all voxels with one of the labels; without labels, of all that
/// are not 0.  What a point is made of is the label of the voxel it lies in; the
/// materials are the labels that the image has of the chosen ones, ascending.
///
/// By the paper's methods a tetrahedron has the label of the voxel nearest to its centroid
/// or, where that one was not chosen, of the chosen voxel at the corner nearest to it.
/// \throws Error `bad_option` (size, margin), `bad_input` (voxels that are not
/// whole numbers, or chosen labels beyond 32 bits), `empty_domain`, `too_large`.
std::unique_ptr<PlacedDomain> label_domain(std::shared_ptr<const Image> image,
                                          std::vector<LabelRange> labels,
                                          const ImageLattice& lattice);

/// Where the image, interpolated trilinearly between voxel centres (and held
/// constant over the outer half of the outermost voxels), is above `level`.
/// \throws Error `bad_option`, `bad_input` (voxels that are NaN, infinite or beyond
/// 1e300), `empty_domain`, `too_large`.
std::unique_ptr<PlacedDomain> level_domain(std::shared_ptr<const Image> image, double level,
                                          const ImageLattice& lattice);

/// 1 in the voxels chosen and 0 in the others, smoothed by a Gaussian of standard
/// deviation `sigma` in world units; beyond the border an image goes on as it ends.
/// Needs four bytes for each voxel.  The same for every number of threads (0: all).
/// \throws Error `bad_option` (sigma, or fewer than 4 voxels along an axis),
/// `empty_domain`, and `bad_input` where ITK was left out.
Image smoothed_labels(const Image& image, std::vector<LabelRange> labels, double sigma,
                      int threads);

/// Where a smoothed image is above one half; points there have the chosen label whose
/// voxel's centre is nearest, tetrahedra that of their centroid.
/// \throws Error as `level_domain`.
std::unique_ptr<PlacedDomain> smoothed_domain(std::shared_ptr<const Image> labelled,
                                             std::vector<LabelRange> labels,
                                             std::shared_ptr<const Image> smoothed,
                                             const ImageLattice& lattice);

/// The part of a solid in a box, closed flat at the box's faces, which belong to it.
/// The lattice is the whole solid's, without the cells beyond the box.
/// \throws Error `bad_option` for a box that is empty, `empty_domain`.
std::unique_ptr<PlacedDomain> cropped_domain(std::unique_ptr<PlacedDomain> whole,
                                            const Bounds& box);

/// The region that a domain makes of a label, and how large it is, in voxels.
struct RegionVolume {
  std::int32_t label = 0;
  std::uint64_t voxels = 0;  ///< that have the label
  double volume = 0;         ///< of the region
};

/// Solids of an image whose labels meet in smooth surfaces.
class InterfaceDomain : public PlacedDomain {
 public:
  /// Whether the lattice has a point at the centre of every voxel, so that no label is lost,
  /// and no piece of one.
  [[nodiscard]] virtual bool keeps_voxels() const = 0;

  /// Of the chosen labels, ascending, counted at 64 points of every cell between voxel
  /// centres.  \throws Error `cancelled`.
  [[nodiscard]] virtual std::vector<RegionVolume> volumes(const Context& context = {}) const = 0;
};

/// How smooth the surfaces are between labels.
struct InterfaceSmoothing {
  /// Standard deviation in world units, at most 4 voxels along any axis; without one it is
  /// 1 voxel along each axis.
  std::optional<double> sigma = {};
};

/// The fields of an image's labels, which `interface_domain` says more of.  They are the same
/// for every lattice.
class LabelFields;

/// \throws Error as `interface_domain`, but for what the lattice is refused for.
std::shared_ptr<const LabelFields> label_fields(std::shared_ptr<const Image> image,
                                                std::vector<LabelRange> labels,
                                                const InterfaceSmoothing& smoothing = {},
                                                const Context& context = {});

/// Every chosen label is a material, and regions meet where smoothed labels are equally
/// strong: each label has a field u, its share of the voxels around a voxel's centre,
/// weighted by (1 4 6 4 1)/16 along every axis, and trilinear in between; beyond the image
/// its outermost voxels go on.  A point has the label whose field is the greatest of those
/// of the voxels whose centres are around it, of equal ones the first, where the outside
/// comes before all labels.  An edge between two labels is cut where their fields are equal.
/// So that no region is lost or shrinks,
///   - u is smoothed less, by (3 10 3)/16, around voxels that lie in no 2 x 2 x 2 voxels of
///     their label;
///   - a constant is added to each label's field by which its region has about the volume of
///     its voxels;
///   - the field of a voxel's own label is raised at its centre where it is not the greatest
///     by a 64th or, near voxels that lie in no such block, by a quarter.
///
/// Where the size is the spacing, or a whole fraction of it, along every axis, even points
/// of the lattice lie at voxel centres.  Each of those has its voxel's label, and between
/// two that share a face and a label so have all points of the lattice: no label is lost,
/// and no piece of one (by faces) is lost or taken apart.  Where the size is the spacing
/// the pieces of the lattice are made of such pieces: of those that touch at an edge or a
/// corner of voxels and, where voxels are as good as noise, of some that are two voxels apart
/// along an axis, since the label has two corners of the voxel between them.  On finer
/// lattices a label may have islets besides, where voxels are as good as noise.
///
/// For other sizes voxels that smoothing might lose have their own label throughout, and
/// keep their flat faces: those in no 2 x 2 x 2 voxels of their label, those that share no
/// such block with a face neighbour of their label, and those whose blocks do not hang
/// together by faces.  Where the size is at most the least spacing each of them has a point
/// of the lattice.  That no piece is lost or taken apart then is tested, not proved; a
/// larger size may lose what is smaller than itself.
///
/// All is computed with whole numbers, and the same for every number of threads.  Needs
/// some 17 bytes, beside the image, for each voxel in blocks of 4 x 4 x 4 where labels are
/// near each other.
/// \throws Error as `label_domain`; `bad_option` (sigma), `cancelled`.
std::unique_ptr<InterfaceDomain> interface_domain(std::shared_ptr<const Image> image,
                                                 std::vector<LabelRange> labels,
                                                 const ImageLattice& lattice,
                                                 const InterfaceSmoothing& smoothing = {},
                                                 const Context& context = {});

/// The same of fields that there are already.
std::unique_ptr<InterfaceDomain> interface_domain(std::shared_ptr<const LabelFields> fields,
                                                 const ImageLattice& lattice,
                                                 const Context& context = {});

/// One label in an image, and what a lattice finds of it.  A piece is what hangs
/// together: voxels by their faces, or by faces, edges and corners; points of the
/// lattice that have the label by the edges of the lattice.  The mesh of a solid has
/// as many pieces as its lattice points do: a lattice tetrahedron is filled exactly
/// where a corner is inside, and the fillings on both sides of a face with a corner
/// inside meet (theorem FaceTriangulationsAgree).
struct ImageRegion {
  std::int32_t label = 0;  ///< 0 for the solid of a level
  std::uint64_t voxels = 0;
  std::uint64_t pieces_by_faces = 0, pieces_by_corners = 0;  ///< in the image
  std::uint64_t points = 0, lattice_pieces = 0;              ///< on the lattice
  /// A lattice of this size has a whole tetrahedron in the region, wherever it lies;
  /// 0 where it was not asked for.  It is half the edge of the largest cube of voxels of the
  /// label, each taken for a cube of the smallest spacing.
  double certain_size = 0;

  /// Voxels that touch at an edge or a corner may hang together in the mesh or not.
  [[nodiscard]] bool keeps_pieces() const {
    return pieces_by_corners <= lattice_pieces && lattice_pieces <= pieces_by_faces;
  }
};

/// The chosen labels that the image has, ascending, with their voxels; no pieces.
std::vector<ImageRegion> regions_of_labels(const Image& image, std::vector<LabelRange> labels);
/// One region: the voxels above the level.
std::vector<ImageRegion> regions_of_level(const Image& image, double level);

/// World units cubed, of all chosen voxels.
double volume_of_labels(const Image& image, const std::vector<LabelRange>& labels);
/// The pieces above a level, between voxels too: those of the voxels by corners and by faces,
/// since every point above the level is joined to a voxel that is, and neighbours by their
/// face are joined.  \throws Error `cancelled`.
PieceBounds pieces_above(const Image& image, double level, const Context& context = {});

/// Counts pieces and points.  Where the domain is one of labels and its size is at
/// most the smallest spacing, nothing can be lost: every voxel has a point of the
/// even lattice, those of voxels that share a face hang together, and an edge is
/// too short to skip a voxel; such a region always `keeps_pieces`.
/// `level` is that of a level's solid.  Regions without a point stay so.
/// \throws Error `cancelled`, at the next layer.
void count_pieces(const Image& image, std::optional<double> level, const PlacedDomain& domain,
                  std::vector<ImageRegion>& regions, const Context& context = {});

/// Finds the `certain_size` of one region.
void find_certain_size(const Image& image, std::optional<double> level,
                       std::vector<ImageRegion>& regions, std::size_t which);

/// The same of an image that nobody else needs.
inline std::unique_ptr<PlacedDomain> label_domain(Image image,
                                                  std::vector<LabelRange> labels = {},
                                                  const ImageLattice& lattice = {}) {
  return label_domain(std::make_shared<const Image>(std::move(image)), std::move(labels),
                      lattice);
}
inline std::unique_ptr<PlacedDomain> level_domain(Image image, double level,
                                                 const ImageLattice& lattice = {}) {
  return level_domain(std::make_shared<const Image>(std::move(image)), level, lattice);
}
inline std::unique_ptr<InterfaceDomain> interface_domain(
    Image image, std::vector<LabelRange> labels = {}, const ImageLattice& lattice = {},
    const InterfaceSmoothing& smoothing = {}, const Context& context = {}) {
  return interface_domain(std::make_shared<const Image>(std::move(image)), std::move(labels),
                          lattice, smoothing, context);
}

}  // namespace certet
