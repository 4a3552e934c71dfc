#pragma once
/// \file
/// Images as solids, to be put on a lattice with others.

#include <memory>
#include <vector>

#include "certet/image.hpp"
#include "certet/solid.hpp"

namespace certet {

// Each has the lattice of its image: along the voxels, by default of their least spacing.  On
// that it answers what the domain of the image alone does.  On another, a position is that of the
// nearest point of a grid of some 2^-17 voxels, and voxels that smoothing might lose have their
// own label throughout, as `interface_domain` says of sizes that are no fraction of the spacing.

/// Where an image is above a level, as `level_domain` has it.  \throws Error as that.
Solid level_solid(std::shared_ptr<const Image> image, double level);

/// The chosen voxels with their faces, as `label_domain` has them; each label is a material.
/// `walls_halfway` is that of the `ImageLattice`.  \throws Error as that.
Solid label_solid(std::shared_ptr<const Image> image, std::vector<LabelRange> labels,
                  bool walls_halfway = false);

/// Labels that meet in smooth surfaces, as `interface_domain` has them.  \throws Error as that.
Solid interface_solid(std::shared_ptr<const Image> image, std::vector<LabelRange> labels,
                      const InterfaceSmoothing& smoothing = {}, const Context& context = {});

/// The image with 1 in the voxels chosen and 0 in the others, so that they are one solid.
/// \throws Error `bad_input` for voxels that are no whole numbers.
Image chosen_as_one(const Image& image, std::vector<LabelRange> labels);

/// The same shape where both x and y change their signs: from LPS to RAS, and back.
Solid turned_over(const Solid& solid);

}  // namespace certet
