#include "label_layers.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace certet {
namespace {

constexpr std::size_t most_told = 8;  ///< more overlaps are only counted

}  // namespace

std::string Segment::title() const {
  return name.empty() ? "label " + std::to_string(label) : "'" + name + "'";
}

void choose_labels(std::vector<Segment>& segments, std::vector<std::string>& notes) {
  std::set<std::int64_t> values;
  bool fit = true;
  for (const Segment& segment : segments)
    fit = fit && segment.value != 0 && std::in_range<std::int32_t>(segment.value) &&
          values.insert(segment.value).second;
  std::int32_t number = 0;
  for (Segment& segment : segments)
    segment.label = fit ? static_cast<std::int32_t>(segment.value) : ++number;
  if (!fit)
    notes.push_back("segments of different layers share their values in the file; their labels "
                    "are numbers from 1, in the order of the header");
}

LabelLayers::LabelLayers(Image& image, std::vector<Segment> segments)
    : image_(image), segments_(std::move(segments)),
      top_(static_cast<std::size_t>(image.size[0] * image.size[1] * image.size[2])) {
  std::ranges::fill(top_, -1);
}

void LabelLayers::add(std::size_t at, std::size_t segment) {
  const auto other = static_cast<std::int32_t>(segment);
  std::int32_t& top = top_[at];
  if (top >= 0 && top != other) ++covered_[{std::max(top, other), std::min(top, other)}];
  top = std::max(top, other);
}

void LabelLayers::finish() {
  for (std::int32_t& voxel : top_)
    voxel = voxel < 0 ? 0 : segments_[static_cast<std::size_t>(voxel)].label;
  image_.voxels = std::move(top_);
  for (const Segment& segment : segments_)
    if (!segment.name.empty()) image_.names[segment.label] = segment.name;
  std::size_t told = 0;
  for (const auto& [pair, voxels] : covered_) {
    if (told++ == most_told) break;
    const auto& upper = segments_[static_cast<std::size_t>(pair.first)];
    const auto& lower = segments_[static_cast<std::size_t>(pair.second)];
    image_.notes.push_back("segments overlap, where the later one wins: " + upper.title() +
                           " covers " + lower.title() + " in " + std::to_string(voxels) +
                           (voxels == 1 ? " voxel" : " voxels"));
  }
  if (covered_.size() > most_told)
    image_.notes.push_back(std::to_string(covered_.size() - most_told) +
                           " more pairs of segments overlap, where the later one wins");
}

}  // namespace certet
