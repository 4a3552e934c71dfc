#pragma once
/// \file
/// What the options name, as a domain.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certet/kept.hpp"
#include "certet/patient_axes.hpp"
#include "certet/write_mesh.hpp"
#include "mesh_options.hpp"

namespace certet::command {

/// What the surfaces of an image's labels are.
enum class LabelSurfaces {
  flat,        ///< the faces of voxels
  smoothed,    ///< the outside alone, smoothed as one solid
  interfaces,  ///< smooth between any two labels
};

/// The voxels of a solid, where it is made of some.
struct SolidVoxels {
  std::shared_ptr<const Image> image;  ///< before smoothing
  std::vector<LabelRange> labels;
  std::optional<double> level = {};
  LabelSurfaces surfaces = LabelSurfaces::flat;
  bool cropped = false;
};

/// How labels were smoothed.
struct Smoothing {
  std::optional<double> sigma;  ///< in world units; nothing: by one voxel along each axis
  double voxel_volume = 0;
};

/// A domain on a lattice of one size.
struct PlacedSource {
  std::shared_ptr<const PlacedDomain> domain;
  Lattice lattice;
  Frame frame;
  double longest_side = 0;  ///< of the solid's box, in world units
  std::optional<double> volume = {};  ///< of the solid, where there is a formula for it
  bool keeps_voxels = false;  ///< no label of the image is lost on the lattice, and no piece
  std::optional<double> room = {};  ///< of the box that a lattice structure fills a part of
  std::uint64_t bytes = 0;
};

/// What has been read, once; it can be placed on lattices of several sizes, one
/// after the other.
struct Source {
  std::string kind;  ///< labels, level, formula, shape, surface, volume or materials
  std::string name;
  /// `size` is the long edge in world units; 0: the source's own choice.
  /// \throws Error.
  std::function<PlacedSource(double size)> place;
  std::vector<std::string> notes = {};  ///< what is doubtful about it, a sentence each
  LabelNames names = {};                ///< where the input tells some
  std::optional<SolidVoxels> voxels = {};
  std::optional<Smoothing> smoothing = {};
  std::optional<PatientAxes> axes = {};  ///< of an image's file, where it tells
  double thin = 0;  ///< how thick its thin parts are, in world units; 0: not known
  KnownPieces pieces = {};  ///< as `SizedShape` has them; of images `RegionWatch` tells
};

/// A domain, on the lattice that it was made for.
PlacedSource placed(std::shared_ptr<const PlacedDomain> domain);

/// A formula as the user gives it: itself or, as @FILE, what that file holds.  \throws Error.
std::string whole_formula(const std::string& text);

/// Of what has no pieces that can be counted but on a lattice.
std::optional<PieceBounds> unknown_pieces(Context& context);

/// Reads the image, surface, volume, formula, shape or several solids.  \throws Error, `cancelled` too.
Source open_source(const MeshOptions& options, std::uint64_t max_bytes, const Context& context);

}  // namespace certet::command
