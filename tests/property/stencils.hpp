#pragma once
/// \file
/// Stencils as a function, so that a test can be given spoilt ones.

#include <functional>

#include "certet/lattice/stencil.hpp"

using Stencils = std::function<certet::Stencil(const certet::CornerSigns&)>;

inline certet::Stencil production(const certet::CornerSigns& signs) {
  return certet::unstructured_tets(signs);
}
