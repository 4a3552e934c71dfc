#include "labels_file.hpp"

#include <string>

#include "certet/error.hpp"
#include "certet/voxelise.hpp"

namespace certet {

LabelsFile labels_file_kind(const std::filesystem::path& file) {
  const std::string last = file.extension().string();
  if (last == ".nrrd") return LabelsFile::nrrd;
  if (last == ".mha") return LabelsFile::meta;
  if (last == ".nii") return LabelsFile::nifti;
  if (last == ".gz" && file.stem().extension() == ".nii") return LabelsFile::nifti_packed;
  throw Error(ErrorCode::bad_option,
              "an image of labels is a .nrrd, .mha, .nii or .nii.gz file, which '" +
                  file.string() + "' is not");
}

void check_labels_file(const std::filesystem::path& file) { labels_file_kind(file); }

}  // namespace certet
