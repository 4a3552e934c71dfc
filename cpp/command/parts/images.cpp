// Stands in for those files of domains/image/ that need ITK.

#include "parts/images.hpp"

#include <utility>

#include "parts/part.hpp"

namespace certet {
namespace {

const command::ImagesPart& images() {
  return command::part<command::ImagesPart>("certet-images");
}

}  // namespace

bool can_read_images() { return true; }

Image read_image(const std::filesystem::path& file, std::uint64_t max_bytes,
                 const ImageChoice& choice) {
  return images().read_image(file, max_bytes, choice);
}

std::optional<PatientAxes> axes_of_file(const std::filesystem::path& image) {
  return images().axes_of_file(image);
}

Image smoothed_labels(const Image& image, std::vector<LabelRange> labels, double sigma,
                      int threads) {
  return images().smoothed_labels(image, std::move(labels), sigma, threads);
}

void write_labels(const Image& labels, const std::filesystem::path& file) {
  images().write_labels(labels, file);
}

}  // namespace certet
