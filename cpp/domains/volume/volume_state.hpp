#pragma once
/// \file
/// The grid of a volume.

#include <openvdb/openvdb.h>

#include "certet/volume.hpp"

namespace certet {

struct Volume::State {
  std::string name;  ///< what sentences call it: the file, and the grid
  openvdb::FloatGrid::ConstPtr grid;
};

}  // namespace certet
