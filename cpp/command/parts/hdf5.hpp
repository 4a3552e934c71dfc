#pragma once
/// \file
/// Files of HDF5, as a part.

#include "certet/formats.hpp"
#include "files/formats/registry.hpp"

namespace certet::command {

struct Hdf5Part {
  static constexpr const char* module = "certet-hdf5";
  formats::OpenWriter *open_xdmf, *open_vtkhdf;
  formats::FileBytes *xdmf_bytes, *vtkhdf_bytes;
};

}  // namespace certet::command
