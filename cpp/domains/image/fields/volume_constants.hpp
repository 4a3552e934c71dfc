#pragma once
/// \file
/// By how much fields are to be raised for regions to keep their volumes.

#include "certet/context.hpp"
#include "fields/hold.hpp"
#include "fields/material_image.hpp"
#include "fields/rules.hpp"

namespace certet::fields {

class NodeFields;

/// For fields that are neither raised nor held yet.  Each of four passes estimates the
/// volumes of all regions and the areas between every two, and solves for the constants
/// by which every region would have the volume of its voxels, if surfaces moved along
/// their normals; the outside's is 0, and none is beyond 0.9.
/// \throws Error `cancelled`.
Constants volume_constants(const NodeFields& fields, const MaterialImage& image,
                           const Rules& rules, const Context& context);

}  // namespace certet::fields
