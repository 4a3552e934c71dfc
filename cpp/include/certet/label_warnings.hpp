#pragma once
/// \file
/// What a mesh has lost of an image's labels, or of those that were asked for.

#include <string>
#include <string_view>
#include <vector>

#include "certet/image.hpp"
#include "certet/mesh.hpp"

namespace certet {

/// How sentences call what they advise: before a number, and before what stands for one.
struct Advice {
  std::string_view size = "a size of ", level = "level_domain";
};

/// What is wrong with a mesh of an image's chosen labels, a sentence each: labels that were
/// asked for one by one and that no voxel has, an image that looks like one of gray values, and
/// labels that the mesh has lost, with a size that keeps each.
std::vector<std::string> warnings_on_labels(const Image& image, std::vector<LabelRange> labels,
                                            const Mesh& mesh, const Advice& advice = {});

// The parts of it, for who has no mesh in memory.

/// Of the labels that were asked for one by one, and not in a range, those that are not among
/// `present`; ascending.
std::vector<std::int64_t> absent_labels(const std::vector<LabelRange>& chosen,
                                        const std::vector<ImageRegion>& present);
/// At most one sentence about them.
std::vector<std::string> sentences_on_absent(const std::vector<std::int64_t>& labels,
                                             std::string_view image);
/// That so many labels look like gray values.
std::string sentence_on_grayscale(std::size_t labels, const Advice& advice = {});
/// That a label is not in the mesh, and its `certain_size`, rounded down.
std::string sentence_on_lost(const ImageRegion& region, const Advice& advice = {});
/// That the volume that a mesh has of a label is `change` of its voxels' more, or less; and at
/// which size that is corrected, or 0 if it was.
std::string sentence_on_volume(const ImageRegion& region, double change, double corrected_at,
                               const Advice& advice = {});

}  // namespace certet
