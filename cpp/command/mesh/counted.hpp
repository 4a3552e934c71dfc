#pragma once
/// \file
/// What is counted before it is written.

#include "certet/stuffing.hpp"
#include "source.hpp"

namespace certet::command {

/// A source on one lattice, and its mesh, counted but not written.
struct Counted {
  PlacedSource source;
  Stuffing stuffing;
};

}  // namespace certet::command
