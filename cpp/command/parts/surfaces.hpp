#pragma once
/// \file
/// Surfaces read through assimp, as a part.

#include "certet/surface.hpp"

namespace certet::command {

struct SurfacesPart {
  static constexpr const char* module = "certet-surfaces";
  decltype(&certet::read_surface) read_surface;
};

}  // namespace certet::command
