#pragma once
/// \file
/// By how much fields are to be raised for regions to keep their volumes.

#include "certet/context.hpp"
#include "fields/hold.hpp"
#include "fields/material_image.hpp"
#include "fields/rules.hpp"

namespace certet::fields {

class NodeFields;

/// Five passes over fields that are neither raised nor held yet.  Each estimates the
/// volumes and areas of all regions and moves the constant of a label by nine tenths of
/// what its region has too much, divided by its area; that of the outside stays 0.
///
/// The estimate takes a node, or the centre of a cell, to be x = 1.25 s d voxels inside
/// of the region of the greatest field, where d is how far that is above the second and
/// s the standard deviation of smoothing; it gives a part f(x) of the volume around to
/// the first and the rest to the second.  A third of the nodes' sum and two thirds of
/// the cells' are a volume.  Sums are of whole numbers, so that no order matters.
/// \throws Error `cancelled`.
Constants volume_constants(const NodeFields& fields, const MaterialImage& image,
                           const Rules& rules, const Context& context);

}  // namespace certet::fields
