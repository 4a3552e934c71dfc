#pragma once
/// \file
/// Images read and written through ITK, as a part.

#include "certet/image.hpp"
#include "certet/patient_axes.hpp"
#include "certet/voxelise.hpp"

namespace certet::command {

struct ImagesPart {
  static constexpr const char* module = "certet-images";
  decltype(&certet::read_image) read_image;
  decltype(&certet::axes_of_file) axes_of_file;
  decltype(&certet::smoothed_labels) smoothed_labels;
  decltype(&certet::write_labels) write_labels;
};

}  // namespace certet::command
