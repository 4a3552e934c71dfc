// Stands in for those files of domains/image/ that need GDCM.

#include "parts/dicom.hpp"

#include "parts/part.hpp"

namespace certet {
namespace {

const command::DicomPart& dicom() { return command::part<command::DicomPart>("certet-dicom"); }

}  // namespace

Image read_dicom(const std::filesystem::path& folder, std::uint64_t max_bytes,
                 const ImageChoice& choice) {
  return dicom().read_dicom(folder, max_bytes, choice);
}

Image read_dicom_file(const std::filesystem::path& file, std::uint64_t max_bytes,
                      const ImageChoice& choice) {
  return dicom().read_dicom_file(file, max_bytes, choice);
}

}  // namespace certet
