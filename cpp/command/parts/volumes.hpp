#pragma once
/// \file
/// Volumes of OpenVDB, as a part.

#include "certet/volume.hpp"

namespace certet::command {

struct VolumesPart {
  static constexpr const char* module = "certet-volumes";
  decltype(&certet::read_volume) read_volume;
  decltype(&certet::volume_domain) volume_domain;
  decltype(&certet::volume_solid) volume_solid;
};

}  // namespace certet::command
