#pragma once
/// \file
/// Surfaces read through assimp, as a part.

#include "certet/surface.hpp"

namespace certet::command {

struct SurfacesPart {
  decltype(&certet::read_surface) read_surface;
};

}  // namespace certet::command
