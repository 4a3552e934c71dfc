#pragma once
/// \file
/// By how much fields are to be raised for regions to keep their volumes.

#include <cstdint>
#include <vector>

#include "certet/context.hpp"
#include "fields/hold.hpp"
#include "fields/material_image.hpp"
#include "fields/rules.hpp"

namespace certet::fields {

class NodeFields;

/// Within what 16 bits hold of all fields.
std::int32_t bounded_constant(double constant);

/// By material.
struct VolumeConstants {
  Constants constants;
  std::vector<double> growths;  ///< voxels that a region gains if its constant grows by 1
};

/// For fields that are neither raised nor held yet.  Each of four passes estimates the
/// volumes of all regions and the areas between every two, and solves for the constants
/// by which every region would have the volume of its voxels, if surfaces moved along
/// their normals; the outside's is 0, and none is beyond 0.9.
/// \throws Error `cancelled`.
VolumeConstants volume_constants(const NodeFields& fields, const MaterialImage& image,
                                 const Rules& rules, const Context& context);

}  // namespace certet::fields
