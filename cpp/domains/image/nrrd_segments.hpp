#pragma once
/// \file
/// The segments of 3D Slicer in an NRRD file (.seg.nrrd).

#include <vector>

#include "label_layers.hpp"
#include "nrrd_header.hpp"

namespace certet {

/// By the pairs `Segment0_LabelValue`, `Segment0_Layer`, `Segment0_Name`, …, in the
/// order of their numbers; none where there are no such pairs.
std::vector<Segment> segments_of(const NrrdHeader& header);

/// Lays the layers, which are the components of each voxel, upon each other.  Values
/// that the header has no segment for become labels of their own below all others.
void merge_layers(Image& image, const Voxels& all, std::uint64_t layers,
                  std::vector<Segment> segments);

}  // namespace certet
