#include "certet/image.hpp"

#include <variant>

#include "reader.hpp"
#include "targets.hpp"

namespace fuzz {
namespace {

constexpr std::uint64_t most_voxel_bytes = 64 << 20;
/// Larger ones are read, but no solid is looked for in them.
constexpr std::int64_t most_voxels = 1 << 18;

std::int64_t voxel_count(const certet::Image& image) {
  const std::size_t count =
      std::visit([](const auto& voxels) { return voxels.size(); }, image.voxels);
  return static_cast<std::int64_t>(count);
}

void place(certet::Image image) {
  const auto shared = std::make_shared<const certet::Image>(std::move(image));
  certet::looks_grayscale(*shared);
  if (shared->integral())
    certet::label_domain(shared, {}, {});
  else
    certet::level_domain(shared, 0.5, {});
}

/// Of floating point ones, too.
void place_labels(certet::Image image) {
  certet::replace_nan(image, 1);
  place(certet::with_labels(std::move(image)));
}

void read_and_place(const std::filesystem::path& path, const certet::ImageChoice& choice = {}) {
  read_or_refuse([&] {
    certet::Image image = certet::read_image(path, most_voxel_bytes, choice);
    const auto& [a, b, c] = image.size;
    const std::int64_t voxels = voxel_count(image);
    if (a < 1 || b < 1 || c < 1 || a * b * c != voxels)
      throw Finding("an image does not have the voxels that its size says");
    if (voxels > most_voxels) return;
    if (!image.integral() && voxels % 2 == 0) place_labels(std::move(image));
    else place(std::move(image));
  });
}

}  // namespace

void image(Bytes bytes) {
  if (bytes.empty()) return;
  static constexpr std::array<std::string_view, 6> extensions{".nii",  ".nii.gz", ".nrrd",
                                                              ".mha", ".tif",    ".dcm"};
  const auto file = chosen_file(bytes, extensions);
  read_and_place(file.path());
  read_and_place(file.path(), {.series = {}, .spacing = {}, .volume = 1});
}

/// Half of the voxels are in each of two files, and all in others.
void image_parts(Bytes bytes) {
  static constexpr std::array<std::string_view, 3> headers{"a.mhd", "a.nhdr", "a.hdr"};
  if (bytes.size() < 3) return;
  const std::size_t length = bytes[1] + std::size_t{bytes[2]} * 256;
  const Bytes rest = bytes.subspan(3);
  const Bytes header = rest.first(std::min(length, rest.size()));
  const Bytes voxels = rest.subspan(header.size());
  const std::string_view name = headers[bytes[0] % headers.size()];
  const InputFolder folder;
  folder.put(name, header);
  folder.put("1.raw", voxels.first(voxels.size() / 2));
  folder.put("2.raw", voxels.subspan(voxels.size() / 2));
  for (const char* const whole : {"a.raw", "a.img"}) folder.put(whole, voxels);
  read_and_place(folder.path() / name);
}

void dicom(Bytes bytes) {
  const InputFolder folder;
  folder.put("1", bytes.first(bytes.size() / 2));
  folder.put("2", bytes.subspan(bytes.size() / 2));
  read_and_place(folder.path());
}

}  // namespace fuzz
