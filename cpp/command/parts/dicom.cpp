// Stands in for those files of domains/image/ that need GDCM.

#include "parts/dicom.hpp"

#include "parts/part.hpp"

namespace certet {

Image read_dicom(const std::filesystem::path& folder, std::uint64_t max_bytes,
                 const ImageChoice& choice) {
  return command::part<command::DicomPart>().read_dicom(folder, max_bytes, choice);
}

Image read_dicom_file(const std::filesystem::path& file, std::uint64_t max_bytes,
                      const ImageChoice& choice) {
  return command::part<command::DicomPart>().read_dicom_file(file, max_bytes, choice);
}

}  // namespace certet
