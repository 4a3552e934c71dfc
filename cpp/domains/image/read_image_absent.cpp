// Stands in for read_image.cpp and smooth.cpp where ITK was left out.

#include "certet/error.hpp"
#include "certet/image.hpp"
#include "certet/patient_axes.hpp"

namespace certet {

bool can_read_images() { return false; }

Image read_image(const std::filesystem::path& file, std::uint64_t, const ImageChoice&) {
  throw Error(ErrorCode::bad_input,
              "'" + file.string() + "' cannot be read: reading images was not built in");
}

std::optional<PatientAxes> axes_of_file(const std::filesystem::path&) { return std::nullopt; }

Image smoothed_labels(const Image& image, std::vector<LabelRange>, double, int) {
  throw Error(ErrorCode::bad_input,
              "'" + image.name + "' cannot be smoothed: that was not built in");
}

}  // namespace certet
