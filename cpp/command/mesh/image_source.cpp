#include "image_source.hpp"

#include <fmt/format.h>

#include <utility>

#include "silence.hpp"

namespace certet::command {
namespace {

Image read(const std::filesystem::path& file, const MeshOptions& options,
           std::uint64_t max_bytes) {
  const Silence silence;
  return read_image(file, max_bytes, options.image);
}

}  // namespace

Image open_image(const std::filesystem::path& file, const MeshOptions& options, bool gray,
                 std::uint64_t max_bytes) {
  Image image = read(file, options, max_bytes);
  if (options.nan)
    if (const std::uint64_t count = replace_nan(image, *options.nan); count != 0)
      image.notes.push_back(fmt::format("{} {} read as {:.9g}", count,
                                        count == 1 ? "voxel is NaN and was" : "voxels are NaN and were",
                                        *options.nan));
  if (gray) return image;
  image = with_labels(std::move(image));
  if (!options.merges.empty()) merge_labels(image, options.merges);
  return image;
}

LabelSurfaces surfaces_of(const MeshOptions& options) {
  if (options.iso || options.smooth == 0.0) return LabelSurfaces::flat;
  if (facts(options.method).interfaces) return LabelSurfaces::interfaces;
  return options.smooth ? LabelSurfaces::smoothed : LabelSurfaces::flat;
}

}  // namespace certet::command
