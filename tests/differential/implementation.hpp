#pragma once
/// \file
/// The production side of every comparison, as a value: so that the same
/// comparison can be run on a variant with a planted bug, which it must catch.

#include <array>
#include <functional>

#include "certet/lattice/stencil.hpp"
#include "certet/lattice/structured_tet.hpp"
#include "certet/lattice/warp.hpp"

using certet::Coord3;
using certet::Sign;

using NeighborSigns = std::array<Sign, certet::direction_count>;
using NeighborCuts = std::array<std::int32_t, certet::direction_count>;

struct Implementation {
  std::function<certet::StructuredTet(const certet::StructuredTetId&)> structured_tet =
      [](const certet::StructuredTetId& id) { return certet::structured_tet(id); };

  std::function<bool(certet::StructuredTetCase)> right_handed =
      [](certet::StructuredTetCase c) { return certet::right_handed(c); };

  std::function<certet::Stencil(const certet::CornerSigns&)> unstructured_tets =
      [](const certet::CornerSigns& signs) { return certet::unstructured_tets(signs); };

  std::function<certet::Warping(certet::Thresholds, Sign, const NeighborSigns&,
                                const NeighborCuts&)>
      warp = [](certet::Thresholds t, Sign s, const NeighborSigns& n, const NeighborCuts& c) {
        return certet::warp(t, s, n, c);
      };
};
