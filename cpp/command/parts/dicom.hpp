#pragma once
/// \file
/// DICOM read through GDCM, as a part.

#include "domains/image/image_file.hpp"

namespace certet::command {

struct DicomPart {
  ReadImage *read_dicom, *read_dicom_file;
};

}  // namespace certet::command
