// Stands in for those files of domains/image/ that need ITK.

#include "parts/images.hpp"

#include <utility>

#include "parts/part.hpp"

namespace certet {

bool can_read_images() { return true; }

Image read_image(const std::filesystem::path& file, std::uint64_t max_bytes,
                 const ImageChoice& choice) {
  return command::part<command::ImagesPart>().read_image(file, max_bytes, choice);
}

std::optional<PatientAxes> axes_of_file(const std::filesystem::path& image) {
  return command::part<command::ImagesPart>().axes_of_file(image);
}

Image smoothed_labels(const Image& image, std::vector<LabelRange> labels, double sigma,
                      int threads) {
  return command::part<command::ImagesPart>().smoothed_labels(image, std::move(labels), sigma,
                                                              threads);
}

void write_labels(const Image& labels, const std::filesystem::path& file) {
  command::part<command::ImagesPart>().write_labels(labels, file);
}

}  // namespace certet
