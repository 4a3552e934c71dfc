#include "regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

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

PieceBounds bounds_of(const ImageRegion& region) {
  return {region.pieces_by_corners, region.pieces_by_faces};
}

constexpr Advice in_options{"--size ", "--iso V"};

}  // namespace

bool keeps_pieces(const SolidVoxels& voxels, std::span<const ImageRegion> regions,
                  const PlacedDomain& domain, const Pieces& mesh, const Context& context) {
  if (voxels.level) return may_be(bounds_of(regions.front()), mesh.whole);
  std::vector<ImageRegion> found(regions.size());
  for (std::size_t r = 0; r < found.size(); ++r) found[r].label = regions[r].label;
  count_pieces(*voxels.image, voxels.level, domain, found, context);
  return std::ranges::all_of(found, &ImageRegion::keeps_pieces);
}

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
  if (solid.cropped || placed.keeps_voxels) return;
  counted_pieces_ = true;
  if (!solid.level) {
    count_pieces(*solid.image, {}, *placed.domain, regions_, context);
    return;
  }
  const auto [least, most] = pieces_above(*solid.image, *solid.level, context);
  regions_[0].pieces_by_corners = least;
  regions_[0].pieces_by_faces = most;
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

void RegionWatch::see_no_pieces() {
  pieces_.assign(regions_.size(), std::nullopt);
  counted_pieces_ = false;
}

std::vector<MeshedRegion> RegionWatch::regions(std::uint64_t all_tets) const {
  std::vector<MeshedRegion> result;
  const bool whole = source_.voxels && !source_.voxels->level && !source_.voxels->cropped &&
                     !dropped_;
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const auto& spacing = source_.voxels->image->spacing;
    const double voxel = spacing[0] * spacing[1] * spacing[2];
    MeshedRegion one{regions_[r], source_.voxels->level ? all_tets : tets_[r], volumes_[r],
                     voxel * static_cast<double>(regions_[r].voxels)};
    if (whole && one.volume > 0) one.change = one.volume / one.voxel_volume - 1;
    one.pieces = pieces_[r];
    result.push_back(one);
  }
  return result;
}

bool RegionWatch::is_lost(std::size_t which, bool written) const {
  if (source_.voxels->level) return false;
  return written ? tets_[which] == 0 : counted_pieces_ && regions_[which].points == 0;
}

std::string RegionWatch::lost(std::size_t which) {
  const ImageRegion& region = regions_[which];
  const std::string text = fmt::format("label {} ({} voxels) is not in the mesh", region.label,
                                       region.voxels);
  if (dropped_) return text + ", of which pieces were dropped";
  if (source_.voxels->cropped) return text + ", as far as it is cropped";
  if (source_.voxels->surfaces == LabelSurfaces::smoothed)
    return text + "; a smaller --smooth may keep it";
  find_certain_size(*source_.voxels->image, source_.voxels->level, regions_, which);
  return sentence_on_lost(region, in_options);
}

bool RegionWatch::keeps(std::size_t which) const {
  const std::optional<PieceCount>& mesh = pieces_[which];
  return mesh ? may_be(bounds_of(regions_[which]), *mesh) : regions_[which].keeps_pieces();
}

std::string RegionWatch::other_pieces(std::size_t which) const {
  const ImageRegion& region = regions_[which];
  const bool exact = region.pieces_by_corners == region.pieces_by_faces;
  const std::optional<PieceCount>& mesh = pieces_[which];
  const std::uint64_t pieces = mesh ? mesh->by_faces : region.lattice_pieces;
  return fmt::format(
      "{} has {} {}, {}{} in the image; ", named(region, source_.voxels->level.has_value()),
      pieces == 1 ? "1 piece" : fmt::format("{} pieces", pieces),
      mesh ? "in the mesh" : "among the lattice's points",
      exact ? "" : fmt::format("{} to ", region.pieces_by_corners), region.pieces_by_faces);
}

/// Of labels that are not smoothed it is known, and of others found.
std::string RegionWatch::size_for_pieces(const std::vector<ImageRegion>& changed,
                                         const SizeFor& size_for) const {
  const bool smoothed = source_.voxels->surfaces == LabelSurfaces::smoothed;
  if (!smoothed && !source_.voxels->level)
    return fmt::format("--size {:.6g} or less keeps them", finest_);
  const KeepingSizes sizes = size_for(changed);
  std::string text = advice_on_pieces(sizes, "--size ");
  return sizes.kept || !smoothed ? text : text + "; a smaller --smooth may keep them";
}

std::vector<std::string> RegionWatch::warnings(bool written, const SizeFor& size_for) {
  std::vector<std::string> sentences;
  if (source_.voxels && !source_.voxels->level) {
    sentences = sentences_on_absent(absent_labels(source_.voxels->labels, regions_), source_.name);
    if (looks_grayscale(*source_.voxels->image))
      sentences.push_back(sentence_on_grayscale(regions_.size(), in_options));
  }
  std::size_t lost_ones = 0;
  std::vector<std::string> others;
  std::vector<ImageRegion> changed;
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    if (is_lost(r, written)) {
      if (++lost_ones <= most_told) sentences.push_back(lost(r));
    } else if (counted_pieces_ && !dropped_ && !keeps(r)) {
      changed.push_back(regions_[r]);
      if (changed.size() <= most_told) others.push_back(other_pieces(r));
    }
  }
  if (lost_ones > most_told)
    sentences.push_back(fmt::format("{} more labels are not in the mesh", lost_ones - most_told));
  const std::string size = changed.empty() ? "" : size_for_pieces(changed, size_for);
  for (const std::string& other : others) sentences.push_back(other + size);
  if (changed.size() > most_told)
    sentences.push_back(fmt::format("{} more labels have other pieces than in the image",
                                    changed.size() - most_told));
  if (written) std::ranges::move(other_volumes(), std::back_inserter(sentences));
  return sentences;
}

/// Of smooth interfaces, and of labels that are no smaller than those whose volumes are seen to:
/// what is smaller has a volume of its own in every mesh, as the table and the JSON tell.
std::vector<std::string> RegionWatch::other_volumes() const {
  constexpr std::uint64_t fewest_voxels = 1000;
  constexpr double most_change = 0.01;
  std::vector<std::string> sentences;
  if (!source_.voxels || source_.voxels->surfaces != LabelSurfaces::interfaces) return sentences;
  const auto& spacing = source_.voxels->image->spacing;
  const double as_large = std::cbrt(spacing[0] * spacing[1] * spacing[2]);
  const double corrected_at = size_ > 1.0003 * as_large ? as_large : 0;
  std::size_t count = 0;
  for (const MeshedRegion& one : regions(0)) {
    if (one.region.voxels < fewest_voxels || std::abs(one.change.value_or(0)) <= most_change)
      continue;
    if (++count <= most_told)
      sentences.push_back(sentence_on_volume(one.region, *one.change, corrected_at, in_options));
  }
  if (count > most_told)
    sentences.push_back(fmt::format("{} more labels have other volumes than their voxels, by more "
                                    "than 1 %", count - most_told));
  return sentences;
}

}  // namespace certet::command
