#pragma once
/// \file
/// Segments that may overlap, as one image of labels.

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "certet/image.hpp"

namespace certet {

/// Where a file has it, and what becomes of it.
struct Segment {
  std::uint64_t layer = 0;
  std::int64_t value = 1;  ///< of its voxels in the layer
  std::int32_t label = 0;  ///< of its voxels in the image; never 0
  std::string name;
  [[nodiscard]] std::string title() const;
};

/// Gives every segment its value for a label where no two share one, else numbers
/// from 1 in their order, which a note says.
void choose_labels(std::vector<Segment>& segments, std::vector<std::string>& notes);

/// Lays segments upon each other; the later covers the earlier, and what it covers is
/// counted.
class LabelLayers {
 public:
  /// `image` needs its size.
  LabelLayers(Image& image, std::vector<Segment> segments);

  /// Voxel `at` belongs to segment number `segment`, too.
  void add(std::size_t at, std::size_t segment);

  /// Gives the image its voxels, its names, and a sentence about every overlap.
  void finish();

 private:
  Image& image_;
  std::vector<Segment> segments_;
  Buffer<std::int32_t> top_;  ///< segment numbers, -1 where there is none
  /// Voxels by the segment on top and one below it.
  std::map<std::pair<std::int32_t, std::int32_t>, std::uint64_t> covered_;
};

}  // namespace certet
