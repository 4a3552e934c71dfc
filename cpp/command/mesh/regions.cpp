#include "regions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "certet/label_warnings.hpp"

namespace certet::command {
namespace {

/// More sentences of a kind than this are only counted.
constexpr std::size_t most_told = 8;

std::size_t index_of(const std::vector<ImageRegion>& regions, std::int32_t label) {
  const auto at = std::lower_bound(
      regions.begin(), regions.end(), label,
      [](const ImageRegion& region, std::int32_t value) { return region.label < value; });
  return at != regions.end() && at->label == label
             ? static_cast<std::size_t>(at - regions.begin()) : regions.size();
}

std::string named(const ImageRegion& region, bool level) {
  return level ? "the solid" : fmt::format("label {}", region.label);
}

constexpr Advice in_options{"--size ", "--iso V"};

}  // namespace

RegionWatch::RegionWatch(const Source& source, const PlacedSource& placed,
                         const Context& context)
    : source_(source), size_(placed.frame.size) {
  if (!source.voxels) return;
  const SolidVoxels& solid = *source.voxels;
  finest_ = *std::min_element(solid.image->spacing.begin(), solid.image->spacing.end());
  regions_ = solid.level ? regions_of_level(*solid.image, *solid.level)
                         : regions_of_labels(*solid.image, solid.labels);
  tets_.resize(regions_.size());
  volumes_.resize(regions_.size());
  if (solid.cropped || (size_ <= finest_ && !solid.smoothed)) return;
  count_pieces(*solid.image, solid.level, *placed.domain, regions_, context);
  counted_pieces_ = true;
}

void RegionWatch::see(std::span<const Region> written) {
  for (const Region& region : written) {
    const std::size_t which = index_of(regions_, region.label);
    if (which >= regions_.size()) continue;
    tets_[which] = region.tets;
    volumes_[which] = region.volume * size_ * size_ * size_;
  }
}

/// Of a level they are those of its region.
void RegionWatch::see(const Pieces& pieces, std::span<const RegionPieces> regions,
                      bool dropped) {
  // Where pieces are told of the others, a label without any has none.
  pieces_.assign(regions_.size(),
                 regions.empty() ? std::nullopt : std::optional(PieceCount{}));
  if (regions_.size() == 1) pieces_[0] = pieces.whole;
  for (const RegionPieces& region : regions)
    if (const std::size_t which = index_of(regions_, region.label); which < pieces_.size())
      pieces_[which] = region.pieces;
  whole_ = pieces.whole;
  dropped_ = dropped;
  if (source_.voxels && source_.voxels->level && !dropped)
    for (ImageRegion& region : regions_) region.lattice_pieces = whole_.by_faces;
}

std::vector<MeshedRegion> RegionWatch::regions(std::uint64_t all_tets) const {
  std::vector<MeshedRegion> result;
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const auto& spacing = source_.voxels->image->spacing;
    const double voxel = spacing[0] * spacing[1] * spacing[2];
    result.push_back({regions_[r], source_.voxels->level ? all_tets : tets_[r], volumes_[r],
                      voxel * static_cast<double>(regions_[r].voxels), pieces_[r]});
  }
  return result;
}

bool RegionWatch::is_lost(std::size_t which, bool written) const {
  if (written && !source_.voxels->level) return tets_[which] == 0;
  return counted_pieces_ && regions_[which].points == 0;
}

std::string RegionWatch::lost(std::size_t which) {
  const ImageRegion& region = regions_[which];
  const std::string text = fmt::format("label {} ({} voxels) is not in the mesh", region.label,
                                       region.voxels);
  if (dropped_) return text + ", of which pieces were dropped";
  if (source_.voxels->cropped) return text + ", as far as it is cropped";
  if (source_.voxels->smoothed) return text + "; a smaller --smooth may keep it";
  find_certain_size(*source_.voxels->image, source_.voxels->level, regions_, which);
  return sentence_on_lost(region, in_options);
}

bool RegionWatch::keeps(std::size_t which) const {
  return source_.voxels->level ? keeps_pieces(regions_[which], whole_)
                               : regions_[which].keeps_pieces();
}

std::string RegionWatch::other_pieces(std::size_t which, const SizeFor& size_for) const {
  const ImageRegion& region = regions_[which];
  const bool exact = region.pieces_by_corners == region.pieces_by_faces;
  std::string text = fmt::format(
      "{} has {} in the mesh, {}{} in the image", named(region, source_.voxels->level.has_value()),
      region.lattice_pieces == 1 ? "1 piece" : fmt::format("{} pieces", region.lattice_pieces),
      exact ? "" : fmt::format("{} to ", region.pieces_by_corners), region.pieces_by_faces);
  if (source_.voxels->smoothed) return text + "; a smaller --smooth may keep them";
  if (source_.voxels->level) return text + "; " + size_for(region);
  return text + fmt::format("; --size {:.6g} or less keeps them", finest_);
}

std::vector<std::string> RegionWatch::warnings(bool written, const SizeFor& size_for) {
  std::vector<std::string> sentences;
  if (source_.voxels && !source_.voxels->level) {
    sentences = sentences_on_absent(absent_labels(source_.voxels->labels, regions_), source_.name);
    if (looks_grayscale(*source_.voxels->image))
      sentences.push_back(sentence_on_grayscale(regions_.size(), in_options));
  }
  std::size_t lost_ones = 0, changed = 0;
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    if (is_lost(r, written)) {
      if (++lost_ones <= most_told) sentences.push_back(lost(r));
    } else if (counted_pieces_ && !dropped_ && !keeps(r)) {
      if (++changed <= most_told) sentences.push_back(other_pieces(r, size_for));
    }
  }
  if (lost_ones > most_told)
    sentences.push_back(fmt::format("{} more labels are not in the mesh", lost_ones - most_told));
  if (changed > most_told)
    sentences.push_back(
        fmt::format("{} more labels have other pieces than in the image", changed - most_told));
  return sentences;
}

}  // namespace certet::command
