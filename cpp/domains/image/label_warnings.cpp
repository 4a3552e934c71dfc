#include "certet/label_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

namespace certet {
namespace {

/// More sentences of a kind than this, or labels in one, are only counted.
constexpr std::size_t most_told = 8;

std::set<std::int32_t> labels_in(const Mesh& mesh) {
  std::set<std::int32_t> found;
  for (std::size_t i = 0; i < mesh.labels.size(); ++i)  // labels come in runs
    if (i == 0 || mesh.labels[i] != mesh.labels[i - 1]) found.insert(mesh.labels[i]);
  return found;
}

}  // namespace

std::vector<std::int64_t> absent_labels(const std::vector<LabelRange>& chosen,
                                        const std::vector<ImageRegion>& present) {
  std::set<std::int64_t> absent;
  for (const LabelRange& range : chosen)
    if (range.first == range.last) absent.insert(range.first);
  for (const ImageRegion& region : present) absent.erase(region.label);
  return {absent.begin(), absent.end()};
}

std::vector<std::string> sentences_on_absent(const std::vector<std::int64_t>& labels,
                                             std::string_view image) {
  if (labels.empty()) return {};
  std::string text = "no voxel of '" + std::string(image) + "' has label ";
  for (std::size_t i = 0; i < std::min(labels.size(), most_told); ++i)
    text += (i == 0 ? "" : i + 1 == labels.size() ? " or " : ", ") + std::to_string(labels[i]);
  if (labels.size() > most_told)
    text += ", or " + std::to_string(labels.size() - most_told) + " others that were asked for";
  return {text};
}

std::string sentence_on_grayscale(std::size_t labels, const Advice& advice) {
  return "the image looks like one of gray values, of which " + std::to_string(labels) +
         " became labels; " + std::string(advice.level) + " takes what is above a value";
}

std::string sentence_on_lost(const ImageRegion& region, const Advice& advice) {
  char size[40];
  std::snprintf(size, sizeof size, "%.4g", region.certain_size * (1 - 5e-4));
  return "label " + std::to_string(region.label) + " (" + std::to_string(region.voxels) +
         " voxels) is not in the mesh; " + std::string(advice.size) + size + " or less keeps it";
}

std::string sentence_on_volume(const ImageRegion& region, double change, double corrected_at,
                               const Advice& advice) {
  char percent[40], size[40];
  std::snprintf(percent, sizeof percent, "%.1f", 100 * std::abs(change));
  std::snprintf(size, sizeof size, "%.4g", corrected_at * (1 - 5e-4));
  const std::string text = "the mesh has " + std::string(percent) + " % " +
                           (change < 0 ? "less" : "more") + " volume of label " +
                           std::to_string(region.label) + " than its " +
                           std::to_string(region.voxels) + " voxels";
  return corrected_at == 0
             ? text
             : text + "; " + std::string(advice.size) + size + " or less is corrected for it";
}

std::vector<std::string> warnings_on_labels(const Image& image, std::vector<LabelRange> labels,
                                            const Mesh& mesh, const Advice& advice) {
  std::vector<ImageRegion> regions = regions_of_labels(image, labels);
  std::vector<std::string> sentences = sentences_on_absent(absent_labels(labels, regions), image.name);
  if (looks_grayscale(image)) sentences.push_back(sentence_on_grayscale(regions.size(), advice));
  const std::set<std::int32_t> kept = labels_in(mesh);
  std::size_t lost = 0;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    if (kept.contains(regions[r].label) || ++lost > most_told) continue;
    find_certain_size(image, {}, regions, r);
    sentences.push_back(sentence_on_lost(regions[r], advice));
  }
  if (lost > most_told)
    sentences.push_back(std::to_string(lost - most_told) + " more labels are not in the mesh");
  return sentences;
}

}  // namespace certet
