#pragma once
/// \file
/// How much of the features the edges of a mesh run along.

#include <vector>

#include "certet/features.hpp"
#include "chain.hpp"

namespace certet::features {

/// Lengths and distances; `chains` are those of the curves.
FeatureFigures measure_features(const Zone& zone, const std::vector<Curve>& curves,
                                const std::vector<Chain>& chains);

}  // namespace certet::features
