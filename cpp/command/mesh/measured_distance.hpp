#pragma once
/// \file
/// How far the mesh of a run is from what it was made of.

#include "certet/frame.hpp"
#include "certet/mesh.hpp"
#include "counted.hpp"
#include "distance.hpp"
#include "source.hpp"

namespace certet::command {

/// Of the mesh that was counted, or of the one in memory, if there is one, whose vertices have moved
/// since.  Lengths are those of the input; the places go out in the frame of the output.
/// \throws Error as `measure_distance`.
DistanceReport measured_distance(const Source& source, const Counted& counted, const Mesh* moved,
                                 const Frame& output, Context& context);

}  // namespace certet::command
