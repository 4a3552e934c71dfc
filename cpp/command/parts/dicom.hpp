#pragma once
/// \file
/// DICOM read through GDCM, as a part.

#include "domains/image/image_file.hpp"

namespace certet::command {

struct DicomPart {
  static constexpr const char* module = "certet-dicom";
  ReadImage *read_dicom, *read_dicom_file;
};

}  // namespace certet::command
