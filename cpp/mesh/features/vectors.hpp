#pragma once
/// \file
/// The optimiser's vectors and their arithmetic.

#include "mesh/optimise/vector.hpp"

namespace certet::features {

using optimising::Vector;
using optimising::between;
using optimising::cross;
using optimising::dot;
using optimising::length;
using optimising::operator+;
using optimising::operator-;
using optimising::operator*;

}  // namespace certet::features
